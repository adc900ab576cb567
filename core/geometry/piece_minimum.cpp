// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/piece_minimum.h"

#include "core/geometry/convex_minimum.h"

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

constexpr double tolerance = 2e-9; // mm

/// The point of a triangle's plane where the piece's signed distance is least.
struct PlaneMinimum {
    glm::dvec3 point{0.0};
    double distance = 0.0;
};

/// By symmetry the minimum lies in the plane through the axis and the normal: one line across the piece's profile.
PlaneMinimum minimumOverPlane(const PlacedPiece& placed, const glm::dvec3& normal, const glm::dvec3& onPlane,
                              double cutoff) noexcept {
    const RevolvedPiece& piece = placed.piece();
    const auto& [tip, axis] = placed.pose();
    const double normalAxial = glm::dot(normal, axis);
    const glm::dvec3 across = normal - normalAxial * axis;
    const double normalRadial = glm::length(across);
    const double offset = glm::dot(normal, onPlane - tip);
    if (normalRadial < 1e-9) { // perpendicular to the axis, which meets the plane at the minimum
        const double height = offset / normalAxial;
        return {tip + height * axis, signedDistance(piece, 0.0, height)};
    }
    const glm::dvec3 radial = across / normalRadial;
    // Foot of the piece's middle on the line; the minimum is no farther from it than the piece's farthest point.
    const double middle = 0.5 * (piece.bottom + piece.top);
    const double beside = offset - normalAxial * middle;
    const double footX = beside * normalRadial, footZ = middle + beside * normalAxial;
    const double reach = std::hypot(piece.widestRadius(), piece.top - middle) + 1e-6;
    const double alongX = -normalAxial, alongZ = normalRadial;
    const auto profile = [&](double t) noexcept -> LineValue {
        const double x = footX + t * alongX, z = footZ + t * alongZ;
        const PieceDistance d = signedDistanceAndSlope(piece, std::abs(x), z);
        return {d.distance, (x < 0.0 ? -d.alongRadius : d.alongRadius) * alongX + d.alongHeight * alongZ};
    };
    const LineMinimum least = minimumOnLine(profile, -reach, reach, cutoff, tolerance);
    return {tip + (footX + least.place * alongX) * radial + (footZ + least.place * alongZ) * axis, least.value};
}

std::optional<PieceMinimum> minimumOverEdge(const PlacedPiece& placed, const Triangle& triangle, int edge,
                                            double cutoff) noexcept {
    const int next = (edge + 1) % 3;
    const glm::dvec3& from = triangle[static_cast<std::size_t>(edge)];
    const glm::dvec3 way = triangle[static_cast<std::size_t>(next)] - from;
    const auto along = [&](double t) noexcept -> LineValue {
        const PlacedPiece::Value v = placed.at(from + t * way);
        return {v.distance, glm::dot(v.gradient, way)};
    };
    const LineMinimum least = minimumOnLine(along, 0.0, 1.0, cutoff, tolerance);
    if (!(least.value < cutoff)) return std::nullopt;
    const TriangleFeature feature = least.place <= 0.0   ? cornerFeature(edge)
                                    : least.place >= 1.0 ? cornerFeature(next)
                                                         : edgeFeature(edge);
    return PieceMinimum{least.value, from + least.place * way, feature};
}

/// If the ball itself is nearest, the result is the point nearest to its centre.
std::optional<PieceMinimum> minimumToBall(const PlacedPiece& placed, const Triangle& triangle) noexcept {
    const double radius = placed.piece().cornerRadius;
    const glm::dvec3 centre = placed.pose().tip + (placed.piece().bottom + radius) * placed.pose().axis;
    const TrianglePoint nearest = closestOnTriangle(triangle, centre);
    const glm::dvec3 way = nearest.point - centre;
    if (glm::dot(way, placed.pose().axis) > 0.0) return std::nullopt;
    const double distance = glm::length(way) - radius;
    const bool topIsNear = placed.piece().top < placed.piece().bottom + 2.0 * radius;
    if (distance < 0.0 && topIsNear) return std::nullopt; // inside, the top face may be nearer than the ball's
    return PieceMinimum{distance, nearest.point, nearest.feature};
}

} // namespace

TriangleBounds boundsOverTriangle(const PlacedPiece& piece, const Triangle& triangle) noexcept {
    const glm::dvec3 centroid = (triangle[0] + triangle[1] + triangle[2]) / 3.0;
    const PlacedPiece::Value value = piece.at(centroid);
    const double fall =
        std::min({glm::dot(value.gradient, triangle[0] - centroid), glm::dot(value.gradient, triangle[1] - centroid),
                  glm::dot(value.gradient, triangle[2] - centroid)});
    return {centroid, value.distance, value.distance + fall}; // a convex function stays above its tangents
}

std::optional<PieceMinimum> minimumOverTriangle(const PlacedPiece& piece, const Triangle& triangle,
                                                double cutoff) noexcept {
    if (boundsOverTriangle(piece, triangle).below >= cutoff) return std::nullopt;

    if (piece.ballEnd()) {
        if (const std::optional<PieceMinimum> ball = minimumToBall(piece, triangle))
            return ball->distance < cutoff ? ball : std::nullopt;
    }

    std::array<bool, 3> beyond{true, true, true};
    const glm::dvec3 normal = areaNormal(triangle);
    const double area = glm::length(normal);
    const double longest = std::max({glm::dot(triangle[1] - triangle[0], triangle[1] - triangle[0]),
                                     glm::dot(triangle[2] - triangle[1], triangle[2] - triangle[1]),
                                     glm::dot(triangle[0] - triangle[2], triangle[0] - triangle[2])});
    if (area > 1e-10 * longest) { // a sliver has no well-defined plane; only its edges are evaluated
        const PlaneMinimum plane = minimumOverPlane(piece, normal / area, triangle[0], cutoff);
        if (plane.distance >= cutoff) return std::nullopt;
        for (std::size_t edge = 0; edge < 3; ++edge) {
            const glm::dvec3 way = triangle[(edge + 1) % 3] - triangle[edge];
            beyond[edge] = glm::dot(glm::cross(way, plane.point - triangle[edge]), normal) < 0.0;
        }
        if (!beyond[0] && !beyond[1] && !beyond[2])
            return PieceMinimum{plane.distance, plane.point, TriangleFeature::face};
    }
    std::optional<PieceMinimum> best;
    for (int edge = 0; edge < 3; ++edge) {
        if (!beyond[static_cast<std::size_t>(edge)]) continue;
        if (const auto candidate = minimumOverEdge(piece, triangle, edge, best ? best->distance : cutoff))
            best = candidate;
    }
    return best;
}

} // namespace burin
