// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/field/tip_asker.h"

#include "core/geometry/piece_minimum.h"

#include <algorithm>
#include <array>

namespace burin {

namespace {

const glm::dvec3 upright(0.0, 0.0, 1.0);
constexpr double alike = 0.98; // cosine: the mesh's normal is the direction of a contact, not the mean of two faces

/// Where two faces of a piece are equally near, any mean of their slopes is one of the depth; that of its least value
/// over a smooth surface is the one along the surface's normal.
glm::dvec3 alongNormal(const std::array<glm::dvec3, 3>& slopes, const glm::dvec3& normal) noexcept {
    const auto across = [&](const glm::dvec3& slope) { return slope - glm::dot(slope, normal) * normal; };
    glm::dvec3 best = slopes[0];
    double least = glm::length(across(best));
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 &from = slopes[i], &to = slopes[(i + 1) % 3];
        const glm::dvec3 way = across(to) - across(from);
        const double square = glm::dot(way, way);
        if (!(square > 1e-12)) continue;
        const glm::dvec3 mean =
            glm::mix(from, to, std::clamp(-glm::dot(across(from), way) / square, 0.0, 1.0));
        const double rest = glm::length(across(mean));
        if (!(rest < least)) continue;
        least = rest;
        best = mean;
    }
    return best;
}

} // namespace

TipAsker::TipAsker(const MeshDistance& part, const ToolFieldRequest& request, const ClearanceTolerance& tolerance)
    : request_(request), tolerance_(tolerance), asker_(part, request.tool, upright) {}

PartSample TipAsker::ask(const glm::dvec3& tip) {
    const ToolClearance found = asker_.ask(tip, 1e300, tolerance_);
    if (!(found.clearance < farthestClearance)) return {static_cast<float>(farthestClearance), glm::vec3(0.0F)};
    return {static_cast<float>(found.clearance), glm::vec3(gradientOf(found, tip))};
}

glm::dvec3 TipAsker::gradientOf(const ToolClearance& found, const glm::dvec3& tip) const noexcept {
    const double length = glm::length(found.outward);
    if (!(length > 0.0)) return found.away;
    const glm::dvec3 normal = found.outward / length;
    if (glm::dot(normal, found.away) > alike) return normal;
    if (found.clearance > 0.0) return found.away;
    const PlacedPiece piece(request_.tool[found.piece], {tip, upright});
    const glm::dvec2 aside(found.meshPoint - tip);
    const double radius = glm::length(aside), aLittle = 0.01 * request_.voxel;
    const glm::dvec3 outwards = radius > 0.0 ? glm::dvec3(aside / radius, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
    return -alongNormal({piece.at(found.meshPoint + aLittle * outwards).gradient,
                         piece.at(found.meshPoint + aLittle * upright).gradient,
                         piece.at(found.meshPoint - aLittle * upright).gradient},
                        normal);
}

} // namespace burin
