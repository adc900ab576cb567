// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cmath>
#include <optional>

namespace burin {

/// A convex solid of revolution about the tool axis: a frustum whose bottom edge may be rounded, or whose side may
/// bulge in an arc. A tool is a stack of them (flutes, shank, holder), so that the geometry code needs no knowledge of
/// tools. Ball end: bottomRadius = topRadius = cornerRadius. Flat end: cornerRadius = 0. Bull nose: between. Bulging
/// side (zone of a sphere or torus): made by `bulgingPiece`.
struct RevolvedPiece {
    double bottom = 0.0;       ///< mm above the tip along the axis
    double top = 0.0;          ///< mm above the tip, > bottom, >= bottom + cornerRadius
    double bottomRadius = 0.0; ///< mm, before rounding
    double topRadius = 0.0;    ///< mm
    double cornerRadius = 0.0; ///< mm, 0 … bottomRadius; only where bottomRadius == topRadius and the side is straight
    double bulgeRadius = 0.0;  ///< mm, of the side's arc; 0: straight
    double bulgeCentreRadius = 0.0; ///< mm, of the arc's centre from the axis; 0: a sphere; negative: beyond the axis
    double bulgeCentreHeight = 0.0; ///< mm above the tip, of the arc's centre

    bool bulges() const noexcept { return bulgeRadius > 0.0; }
    /// Greatest distance of the piece from the axis, mm.
    double widestRadius() const noexcept {
        const double ends = bottomRadius > topRadius ? bottomRadius : topRadius;
        const bool passesEquator = bulges() && bottom < bulgeCentreHeight && bulgeCentreHeight < top;
        return passesEquator ? bulgeCentreRadius + bulgeRadius : ends;
    }
};

/// The zone between two heights of the solid whose profile is an arc about (centreRadius, centreHeight), with the
/// outside away from the axis. `bottom` and `top` within centreHeight ± radius; no radius of the zone may be negative.
inline RevolvedPiece bulgingPiece(double bottom, double top, double centreRadius, double centreHeight,
                                  double radius) noexcept {
    const auto radiusAt = [&](double height) {
        const double up = height - centreHeight, square = (radius - up) * (radius + up);
        const double at = centreRadius + (square > 0.0 ? std::sqrt(square) : 0.0);
        return at > 0.0 ? at : 0.0;
    };
    return {bottom, top, radiusAt(bottom), radiusAt(top), 0.0, radius, centreRadius, centreHeight};
}

/// Interval of heights above the tip, mm.
struct HeightRange {
    double low = 0.0, high = 0.0;
};
/// The heights that the piece covers at a distance from its axis, mm; empty beyond its widest radius. The interval
/// shrinks with the distance.
std::optional<HeightRange> heightsAt(const RevolvedPiece& piece, double radius) noexcept;

/// Radius of the piece at a height between its faces, mm.
double radiusAt(const RevolvedPiece& piece, double height) noexcept;

/// A circle of a solid of revolution.
struct ProfilePoint {
    double radius = 0.0; ///< mm from the axis
    double height = 0.0; ///< mm above the tip
};
/// The piece's farthest circle in a direction, given by its components away from the axis and along it (`radial` >= 0,
/// not both 0): where radius · radial + height · axial is greatest.
ProfilePoint farthestIn(const RevolvedPiece& piece, double radial, double axial) noexcept;

/// Signed distance with its slopes along the two cylinder coordinates, which together have unit length, except on the
/// piece's inner ridges, where they are those of one of the adjacent faces (a subgradient).
struct PieceDistance {
    double distance = 0.0; ///< mm, negative inside
    double alongRadius = 0.0;
    double alongHeight = 0.0;
};

/// Signed distance, mm, from a point to the piece, negative inside; the point in cylinder coordinates of the tool
/// frame: `radius` >= 0 from the axis, `height` above the tip. Exact outside and inside; convex; 1-Lipschitz.
inline double signedDistance(const RevolvedPiece& piece, double radius, double height) noexcept;

/// The same with its slopes.
inline PieceDistance signedDistanceAndSlope(const RevolvedPiece& piece, double radius, double height) noexcept;

// Called hundreds of times for one clearance: visible to the compiler for inlining.
namespace profile {

/// Distance to a point of the profile. On the point itself the slope is that of `face`, which ends there.
inline PieceDistance fromPoint(double radial, double axial, const PieceDistance& face) noexcept {
    const double distance = std::sqrt(radial * radial + axial * axial);
    if (distance > 0.0) return {distance, radial / distance, axial / distance};
    return {0.0, face.alongRadius, face.alongHeight};
}

/// The nearer of the flat faces, for a point inside, or one beyond one of them.
inline PieceDistance bottomOrTop(const RevolvedPiece& piece, double height) noexcept {
    const double below = piece.bottom - height;
    const double above = height - piece.top;
    return below > above ? PieceDistance{below, 0.0, -1.0} : PieceDistance{above, 0.0, 1.0};
}

inline PieceDistance cylinder(const RevolvedPiece& piece, double radius, double height) noexcept {
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

PieceDistance frustum(const RevolvedPiece& piece, double radius, double height) noexcept;
PieceDistance bulge(const RevolvedPiece& piece, double radius, double height) noexcept;

} // namespace profile

inline PieceDistance signedDistanceAndSlope(const RevolvedPiece& piece, double radius, double height) noexcept {
    if (piece.bulges()) return profile::bulge(piece, radius, height);
    return piece.bottomRadius == piece.topRadius ? profile::cylinder(piece, radius, height)
                                                 : profile::frustum(piece, radius, height);
}

inline double signedDistance(const RevolvedPiece& piece, double radius, double height) noexcept {
    return signedDistanceAndSlope(piece, radius, height).distance;
}

} // namespace burin
