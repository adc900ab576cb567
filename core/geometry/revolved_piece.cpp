// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/revolved_piece.h"

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

/// Distance to a point of the profile. On the point itself the slope is `face`'s, which meets it.
PieceDistance fromPoint(double radial, double axial, const PieceDistance& face) noexcept {
    const double distance = std::sqrt(radial * radial + axial * axial);
    if (distance > 0.0) return {distance, radial / distance, axial / distance};
    return {0.0, face.alongRadius, face.alongHeight};
}

/// The nearest of the flat faces, for a point inside or with one face in its way.
PieceDistance bottomOrTop(const RevolvedPiece& piece, double height) noexcept {
    const double below = piece.bottom - height;
    const double above = height - piece.top;
    return below > above ? PieceDistance{below, 0.0, -1.0} : PieceDistance{above, 0.0, 1.0};
}

PieceDistance cylinder(const RevolvedPiece& piece, double radius, double height) noexcept {
    const double corner = piece.cornerRadius;
    const double fromRing = radius - (piece.bottomRadius - corner);
    const double overRing = height - (piece.bottom + corner);
    if (corner > 0.0 && fromRing > 0.0 && overRing < 0.0) {
        PieceDistance rounding = fromPoint(fromRing, overRing, {});
        rounding.distance -= corner;
        const double above = height - piece.top;
        return rounding.distance >= above ? rounding : PieceDistance{above, 0.0, 1.0};
    }
    const double beside = radius - piece.bottomRadius;
    const PieceDistance flat = bottomOrTop(piece, height);
    if (beside > 0.0 && flat.distance > 0.0) return fromPoint(beside, flat.alongHeight * flat.distance, flat);
    return beside > flat.distance ? PieceDistance{beside, 1.0, 0.0} : flat;
}

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

} // namespace

PieceDistance signedDistanceAndSlope(const RevolvedPiece& piece, double radius, double height) noexcept {
    return piece.bottomRadius == piece.topRadius ? cylinder(piece, radius, height) : frustum(piece, radius, height);
}

double signedDistance(const RevolvedPiece& piece, double radius, double height) noexcept {
    return signedDistanceAndSlope(piece, radius, height).distance;
}

} // namespace burin
