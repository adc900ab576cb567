// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/pose.h"
#include "core/geometry/revolved_piece.h"
#include "core/geometry/triangle.h"

#include <optional>

namespace burin {

/// A piece of a tool at a pose, evaluated at points of the frame that the pose is given in.
class PlacedPiece {
public:
    PlacedPiece(const RevolvedPiece& piece, const ToolPose& pose) noexcept : piece_(piece), pose_(pose) {}

    struct Value {
        double distance = 0.0;    ///< mm, signed: negative inside
        glm::dvec3 gradient{0.0}; ///< a subgradient of the signed distance, at most unit length
    };
    /// @param point mm, in the frame of the pose
    Value at(const glm::dvec3& point) const noexcept;

    const RevolvedPiece& piece() const noexcept { return piece_; }
    const ToolPose& pose() const noexcept { return pose_; }
    /// Whether it is a cylinder with a hemispherical end.
    bool ballEnd() const noexcept {
        return piece_.cornerRadius > 0.0 && piece_.cornerRadius == piece_.bottomRadius &&
               piece_.bottomRadius == piece_.topRadius;
    }

private:
    RevolvedPiece piece_;
    ToolPose pose_;
};

struct PieceMinimum {
    double distance = 0.0; ///< mm, the least signed distance
    glm::dvec3 point{0.0}; ///< of the triangle, where the minimum is attained
    TriangleFeature feature = TriangleFeature::face;
};

/// Bounds of the least signed distance over a triangle from one evaluation at its middle, mm: at most `above`, the
/// value at `centroid`, and at least `below`.
struct TriangleBounds {
    glm::dvec3 centroid{0.0};
    double above = 0.0;
    double below = 0.0;
};
TriangleBounds boundsOverTriangle(const PlacedPiece& piece, const Triangle& triangle) noexcept;

/// Least signed distance from the points of a triangle to a piece, exact to 1e-8 mm. Empty if it is not below `cutoff`,
/// mm. The signed distance of a convex body is convex: its minimum over the triangle's plane is the minimum over the
/// triangle if it lies in it, and otherwise the minimum is on one of the edges that this point is beyond.
std::optional<PieceMinimum> minimumOverTriangle(const PlacedPiece& piece, const Triangle& triangle,
                                                double cutoff) noexcept;

inline PlacedPiece::Value PlacedPiece::at(const glm::dvec3& point) const noexcept {
    const glm::dvec3 q = point - pose_.tip;
    const double height = glm::dot(q, pose_.axis);
    glm::dvec3 across = q - height * pose_.axis;
    double radius = glm::length(across);
    if (radius < 1e-4) { // mm; most of so short a vector may be a rounding error along the axis
        across -= glm::dot(across, pose_.axis) * pose_.axis;
        radius = glm::length(across);
    }
    const PieceDistance d = signedDistanceAndSlope(piece_, radius, height);
    glm::dvec3 gradient = d.alongHeight * pose_.axis;
    if (radius > 0.0) gradient += (d.alongRadius / radius) * across;
    return {d.distance, gradient};
}

} // namespace burin
