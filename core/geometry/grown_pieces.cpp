// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/grown_pieces.h"

#include <cassert>
#include <cmath>

namespace burin {

std::array<RevolvedPiece, 3> grownPieces(const RevolvedPiece& piece, double by) noexcept {
    assert(!piece.bulges() && piece.cornerRadius == 0.0);
    const double widening = piece.topRadius - piece.bottomRadius, length = piece.top - piece.bottom;
    const double flank = std::hypot(widening, length);
    const double out = by * length / flank, up = -by * widening / flank; // along the side's outward normal
    RevolvedPiece side;
    side.bottom = piece.bottom + up;
    side.top = piece.top + up;
    side.bottomRadius = piece.bottomRadius + out;
    side.topRadius = piece.topRadius + out;
    return {bulgingPiece(piece.bottom - by, piece.bottom + up, piece.bottomRadius, piece.bottom, by), side,
            bulgingPiece(piece.top + up, piece.top + by, piece.topRadius, piece.top, by)};
}

} // namespace burin
