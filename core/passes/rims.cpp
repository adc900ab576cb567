// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/passes/rims.h"

#include "core/passes/workpiece_heights.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace burin {

namespace {

constexpr double rimSlope = 1.7;   // 60 degrees
constexpr double rimShare = 0.5;   // of a rise, within an eighth of its length: a slope rises more evenly
constexpr double leastRise = 0.05; // mm: a lower step does not hold the tool
constexpr double leastPress = 0.2; // mm

} // namespace

double OperatorRims::reachedAt(const glm::dvec2& place) const noexcept {
    return lowestFeasibleHeight(field_, place.x, place.y, 0.0, top_, bottom_);
}

bool OperatorRims::isWall(glm::dvec2 from, double low, glm::dvec2 to, double high) const noexcept {
    constexpr int halvings = 3;
    if (!std::isfinite(low) || !std::isfinite(high)) return false;
    const double least = std::max(leastRise, rimShare * (high - low));
    for (int i = 0; i < halvings && high - low >= least; ++i) { // continue in the half that rises more
        const glm::dvec2 middle = 0.5 * (from + to);
        const double height = reachedAt(middle);
        const bool upper = high - height > height - low;
        (upper ? from : to) = middle;
        (upper ? low : high) = height;
    }
    return high - low >= least && high - low > rimSlope * glm::distance(from, to);
}

bool OperatorRims::isTurnAtRim(const glm::dvec2& place, double reached, const glm::dvec2& direction) const noexcept {
    if (!std::isfinite(reached)) return false;
    const glm::dvec2 beside = place + turningRoom * direction;
    const double height = reachedAt(beside);
    return height < reached - leastRise && isWall(beside, height, place, reached);
}

double OperatorRims::pressAt(const glm::dvec2& place, double reached, double press) const noexcept {
    const std::array<glm::dvec2, 4> directions{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
    const auto isNearRim = [&](double depth) {
        return std::ranges::any_of(directions, [&](const glm::dvec2& direction) {
            const glm::dvec2 beside = place + (depth + swerve) * direction;
            const double height = reachedAt(beside);
            return height < reached - leastRise && isWall(beside, height, place, reached);
        });
    };
    for (double depth = std::min(press, reached - bottom_); depth > 0.0; depth *= 0.5) {
        if (!isNearRim(depth)) return depth;
        if (depth < leastPress) return -overRim;
    }
    return 0.0; // on the floor, which has no rim
}

} // namespace burin
