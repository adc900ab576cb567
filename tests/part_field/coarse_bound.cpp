// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/part_field/coarse_bound.h"

#include "core/field/cube.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin {

namespace {

/// The largest excess of the distance over a value between the corners. The distance is at most the distance to the
/// point which is nearest to a corner; along the axes this is convex and the value linear, so their difference is
/// greatest at corners: of the cube, or of its eighths.
float excess(const std::array<DistanceSample, 8>& corners, float edge) noexcept {
    std::array<glm::vec3, 8> nearest;
    for (int i = 0; i < 8; ++i) {
        const DistanceSample& corner = corners[static_cast<std::size_t>(i)];
        nearest[static_cast<std::size_t>(i)] = edge * glm::vec3(cornerOf(i)) - corner.distance * corner.gradient;
    }
    std::array<std::array<float, 8>, 27> difference; // [position][whose nearest point]
    for (int place = 0; place < 27; ++place) {
        const glm::vec3 share = 0.5F * glm::vec3(place % 3, place / 3 % 3, place / 9);
        float value = 0.0F;
        for (int i = 0; i < 8; ++i) {
            const glm::vec3 weight = glm::mix(1.0F - share, share, glm::vec3(cornerOf(i)));
            value += weight.x * weight.y * weight.z * std::abs(corners[static_cast<std::size_t>(i)].distance);
        }
        for (std::size_t i = 0; i < 8; ++i)
            difference[static_cast<std::size_t>(place)][i] = glm::length(edge * share - nearest[i]) - value;
    }
    float worst = 0.0F;
    for (int eighth = 0; eighth < 8; ++eighth) {
        float best = std::numeric_limits<float>::infinity();
        for (std::size_t i = 0; i < 8; ++i) {
            float most = -std::numeric_limits<float>::infinity();
            for (int j = 0; j < 8; ++j) {
                const glm::ivec3 at = cornerOf(eighth) + cornerOf(j);
                most = std::max(most, difference[static_cast<std::size_t>(at.x + 3 * at.y + 9 * at.z)][i]);
            }
            best = std::min(best, most);
        }
        worst = std::max(worst, best);
    }
    return worst;
}

float leastCorner(const std::array<DistanceSample, 8>& corners) noexcept {
    float least = std::numeric_limits<float>::infinity();
    for (const DistanceSample& corner : corners) least = std::min(least, std::abs(corner.distance));
    return least;
}

} // namespace

CoarseBound coarseBound(const std::array<DistanceSample, 8>& corners, float edge) noexcept {
    const float lipschitz = halfDiagonalAbove * edge, least = leastCorner(corners);
    bool below = false, above = false;
    for (const DistanceSample& corner : corners) (corner.distance < 0.0F ? below : above) = true;
    if (below && above) return {lipschitz, 0.0F};
    // The value may exceed the distance, whose curvature is at most that of the distance to a point.
    float shortfall = lipschitz;
    if (least > lipschitz) shortfall = std::min(shortfall, 0.375F * edge * edge / (least - lipschitz));
    const float error = std::max(shortfall, std::min(lipschitz, excess(corners, edge)));
    const float slack = 1e-5F * (least + edge);
    return {error + slack, std::max(least - shortfall - slack, 0.0F)};
}

bool mayBeWithin(const std::array<DistanceSample, 8>& corners, float edge, float distance) noexcept {
    const float outside = std::sqrt(distance * distance + 0.5F * edge * edge), inside = halfDiagonalAbove * edge;
    return leastCorner(corners) <= std::max(outside, inside) * (1.0F + 1e-5F);
}

} // namespace burin
