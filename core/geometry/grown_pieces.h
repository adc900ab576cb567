// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/revolved_piece.h"

#include <array>

namespace burin {

/// All that is no farther than `by` mm from a piece, as three pieces that cover it together: the rounding about its
/// bottom edge, its side moved out, the rounding about its top edge. Exact.
/// @param piece straight, its bottom edge sharp (shanks and holders are)  @param by > 0
std::array<RevolvedPiece, 3> grownPieces(const RevolvedPiece& piece, double by) noexcept;

} // namespace burin
