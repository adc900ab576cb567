// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/revolved_piece.h"

#include <array>

namespace burin {

/// All points no farther than `by` mm from a piece, as three pieces that cover them together: the rounding about its
/// bottom edge, its side moved outwards, the rounding about its top edge. Exact.
/// @param piece  straight, with a sharp bottom edge (as shanks and holders have)  @param by  > 0
std::array<RevolvedPiece, 3> grownPieces(const RevolvedPiece& piece, double by) noexcept;

} // namespace burin
