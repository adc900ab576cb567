// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/round_corner.h"

#include "core/base/units.h"

#include <algorithm>
#include <cmath>

namespace burin {

std::vector<glm::dvec3> cornerArc(const glm::dvec3& corner, const glm::dvec3& back, const glm::dvec3& on, double leg) {
    constexpr double chord = 0.02; // mm
    if (!(leg > 1e-6)) return {corner};
    const glm::dvec3 u = glm::normalize(back), v = glm::normalize(on);
    const double half = 0.5 * std::acos(std::clamp(glm::dot(u, v), -1.0, 1.0)); // of the inner angle
    const double radius = leg * std::tan(half), turn = pi - 2.0 * half;
    if (turn < 1e-3 || half < 1e-3) return {corner};
    const glm::dvec3 centre = corner + leg / std::cos(half) * glm::normalize(u + v);
    const glm::dvec3 from = corner + leg * u - centre;
    const double step = 2.0 * std::sqrt(2.0 * std::min(1.0, chord / radius));
    const auto steps = static_cast<int>(std::clamp(std::ceil(turn / step), 2.0, 64.0));
    std::vector<glm::dvec3> places;
    for (int k = 0; k <= steps; ++k) {
        const double angle = turn * k / steps;
        places.push_back(centre + std::cos(angle) * from - std::sin(angle) * radius * u);
    }
    return places;
}

std::vector<glm::dvec3> quarterUp(const glm::dvec3& tip, const glm::dvec3& along, double radius) {
    constexpr int chords = 8;
    std::vector<glm::dvec3> places;
    for (int k = 0; k <= chords; ++k) {
        const double angle = 0.5 * pi * k / chords;
        places.push_back(tip + radius * std::sin(angle) * along +
                         glm::dvec3(0.0, 0.0, radius * (1.0 - std::cos(angle))));
    }
    return places;
}

} // namespace burin
