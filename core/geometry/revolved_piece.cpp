// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/revolved_piece.h"

namespace burin::profile {

PieceDistance frustum(const RevolvedPiece& piece, double radius, double height) noexcept {
    const double widening = piece.topRadius - piece.bottomRadius;
    const double length = piece.top - piece.bottom;
    const double flank = std::sqrt(widening * widening + length * length);
    // Outward normal of the flank, and where the point's foot on it lies, counted from the bottom edge.
    const double normalRadial = length / flank, normalAxial = -widening / flank;
    const double radial = radius - piece.bottomRadius, axial = height - piece.bottom;
    const double beside = radial * normalRadial + axial * normalAxial;
    const double along = (radial * widening + axial * length) / flank;

    const PieceDistance flat = bottomOrTop(piece, height);
    if (beside <= 0.0 && flat.distance <= 0.0)
        return beside > flat.distance ? PieceDistance{beside, normalRadial, normalAxial} : flat;
    const double edgeRadius = flat.alongHeight < 0.0 ? piece.bottomRadius : piece.topRadius;
    if (flat.distance > 0.0 && radius <= edgeRadius) return flat;
    if (along <= 0.0) return fromPoint(radial, axial, flat);
    if (along >= flank) return fromPoint(radius - piece.topRadius, height - piece.top, flat);
    return {beside, normalRadial, normalAxial};
}

} // namespace burin::profile
