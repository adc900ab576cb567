// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/supporting_plane.h"

#include <algorithm>
#include <array>

namespace burin {

SupportingPlane supportingPlane(const PlacedPiece& piece, const glm::dvec3& point, const glm::dvec3& normal,
                                double ridge) noexcept {
    const auto& [tip, axis] = piece.pose();
    const glm::dvec3 away = point - tip - glm::dot(point - tip, axis) * axis;
    const double radius = glm::length(away);
    const glm::dvec3 outwards = radius > 0.0 ? away * (ridge / radius) : glm::dvec3(0.0), up = ridge * axis;
    // Tangent planes near the point, each with the vector by which it deviates from the normal.
    struct Tangent {
        double value;
        glm::dvec3 slope, across;
    };
    std::array<Tangent, 3> tangents;
    const std::array<glm::dvec3, 3> sides{outwards, up, -up};
    for (std::size_t i = 0; i < 3; ++i) {
        const PlacedPiece::Value there = piece.at(point + sides[i]);
        tangents[i] = {there.distance - glm::dot(there.gradient, sides[i]), there.gradient,
                       there.gradient - glm::dot(there.gradient, normal) * normal};
    }
    SupportingPlane best{point, tangents[0].value, tangents[0].slope};
    double least = glm::dot(tangents[0].across, tangents[0].across);
    for (std::size_t i = 0; i < 3; ++i) {
        const Tangent &from = tangents[i], &to = tangents[(i + 1) % 3];
        const glm::dvec3 way = to.across - from.across;
        const double square = glm::dot(way, way);
        if (!(square > 1e-12)) continue;
        const double share = std::clamp(-glm::dot(from.across, way) / square, 0.0, 1.0);
        const glm::dvec3 across = from.across + share * way;
        const double rest = glm::dot(across, across);
        if (!(rest < least)) continue;
        least = rest;
        best = {point, glm::mix(from.value, to.value, share), glm::mix(from.slope, to.slope, share)};
    }
    return best;
}

} // namespace burin
