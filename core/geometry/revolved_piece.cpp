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

PieceDistance bulge(const RevolvedPiece& piece, double radius, double height) noexcept {
    const PieceDistance flat = bottomOrTop(piece, height);
    const bool below = flat.alongHeight < 0.0;
    const double edgeRadius = below ? piece.bottomRadius : piece.topRadius;
    const double edgeHeight = below ? piece.bottom : piece.top;
    if (flat.distance > 0.0 && radius <= edgeRadius) return flat;
    const double out = radius - piece.bulgeCentreRadius, over = height - piece.bulgeCentreHeight;
    PieceDistance side = fromPoint(out, over, {0.0, 1.0, 0.0});
    side.distance -= piece.bulgeRadius;
    if (flat.distance <= 0.0) {
        // Between the axis and the centre of a torus zone the flat faces are nearer than the arc's far side.
        return out > 0.0 && side.distance > flat.distance ? side : flat;
    }
    // Beyond an end: the arc is nearest where the point lies within the arc's angle, else its end is.
    const double edgeOut = edgeRadius - piece.bulgeCentreRadius, edgeOver = edgeHeight - piece.bulgeCentreHeight;
    const double turn = edgeOut * over - edgeOver * out; // > 0: the point lies above the end, seen from the centre
    if (below ? turn >= 0.0 : turn <= 0.0) return side;
    return fromPoint(radius - edgeRadius, height - edgeHeight, flat);
}

} // namespace burin::profile
