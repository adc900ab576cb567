// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/revolved_piece.h"

#include <algorithm>

namespace burin {

std::optional<HeightRange> heightsAt(const RevolvedPiece& piece, double radius) noexcept {
    if (radius > piece.widestRadius()) return std::nullopt;
    HeightRange range{piece.bottom, piece.top};
    const auto rounding = [radius](double arcRadius, double centreRadius) {
        const double across = radius - centreRadius;
        return std::sqrt(std::max(0.0, (arcRadius - across) * (arcRadius + across)));
    };
    if (piece.bulges()) {
        const double half = rounding(piece.bulgeRadius, piece.bulgeCentreRadius);
        if (radius > piece.bottomRadius) range.low = piece.bulgeCentreHeight - half;
        if (radius > piece.topRadius) range.high = piece.bulgeCentreHeight + half;
        return range;
    }
    const double flat = piece.bottomRadius - piece.cornerRadius, widening = piece.topRadius - piece.bottomRadius;
    const auto onFlank = [&] {
        return piece.bottom + (piece.top - piece.bottom) * (radius - piece.bottomRadius) / widening;
    };
    if (radius > piece.bottomRadius)
        range.low = onFlank();
    else if (radius > flat)
        range.low = piece.bottom + piece.cornerRadius - rounding(piece.cornerRadius, flat);
    if (radius > piece.topRadius) range.high = onFlank();
    return range;
}

double radiusAt(const RevolvedPiece& piece, double height) noexcept {
    const auto rounding = [](double arcRadius, double up) {
        return std::sqrt(std::max(0.0, (arcRadius - up) * (arcRadius + up)));
    };
    if (piece.bulges()) return piece.bulgeCentreRadius + rounding(piece.bulgeRadius, height - piece.bulgeCentreHeight);
    const double below = piece.bottom + piece.cornerRadius - height;
    if (below > 0.0) return piece.bottomRadius - piece.cornerRadius + rounding(piece.cornerRadius, below);
    const double part = (height - piece.bottom) / (piece.top - piece.bottom);
    return piece.bottomRadius + part * (piece.topRadius - piece.bottomRadius);
}

ProfilePoint farthestIn(const RevolvedPiece& piece, double radial, double axial) noexcept {
    const auto extent = [&](const ProfilePoint& point) { return point.radius * radial + point.height * axial; };
    const auto farther = [&](const ProfilePoint& a, const ProfilePoint& b) { return extent(a) >= extent(b) ? a : b; };
    const double length = std::hypot(radial, axial), outwards = radial / length, upwards = axial / length;
    const double corner = piece.cornerRadius;
    ProfilePoint farthest{piece.topRadius, piece.top};
    if (!(corner > 0.0))
        farthest = farther(farthest, {piece.bottomRadius, piece.bottom});
    else if (axial < 0.0)
        farthest = farther(farthest,
                           {piece.bottomRadius - corner + corner * outwards, piece.bottom + corner + corner * upwards});
    else
        farthest = farther(farthest, {piece.bottomRadius, piece.bottom + corner});
    if (piece.bulges()) {
        const ProfilePoint onArc{piece.bulgeCentreRadius + piece.bulgeRadius * outwards,
                                 piece.bulgeCentreHeight + piece.bulgeRadius * upwards};
        if (onArc.height > piece.bottom && onArc.height < piece.top && onArc.radius > 0.0)
            farthest = farther(farthest, onArc);
    }
    return farthest;
}

} // namespace burin

namespace burin::profile {

PieceDistance frustum(const RevolvedPiece& piece, double radius, double height) noexcept {
    const double widening = piece.topRadius - piece.bottomRadius;
    const double length = piece.top - piece.bottom;
    const double flank = std::sqrt(widening * widening + length * length);
    // Outward normal of the flank, and the position of the point's foot on it, from the bottom edge.
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
    if (flat.distance > 0.0 && radius <= (flat.alongHeight < 0.0 ? piece.bottomRadius : piece.topRadius)) return flat;
    const double out = radius - piece.bulgeCentreRadius, over = height - piece.bulgeCentreHeight;
    PieceDistance side = fromPoint(out, over, {0.0, 1.0, 0.0});
    side.distance -= piece.bulgeRadius;
    // Between the axis and the centre of a torus zone only the flat faces are near.
    if (flat.distance <= 0.0 && out <= 0.0) return flat;
    if (flat.distance <= 0.0 && side.distance <= 0.0) return side.distance > flat.distance ? side : flat;
    // Outside: the arc is nearest if the point lies within its angle, seen from the centre; otherwise one of its ends
    // is.
    const auto liesAbove = [&](double edgeRadius, double edgeHeight) {
        return (edgeRadius - piece.bulgeCentreRadius) * over - (edgeHeight - piece.bulgeCentreHeight) * out;
    };
    if (liesAbove(piece.bottomRadius, piece.bottom) < 0.0)
        return fromPoint(radius - piece.bottomRadius, height - piece.bottom, {0.0, 0.0, -1.0});
    if (liesAbove(piece.topRadius, piece.top) > 0.0)
        return fromPoint(radius - piece.topRadius, height - piece.top, {0.0, 0.0, 1.0});
    return side;
}

} // namespace burin::profile
