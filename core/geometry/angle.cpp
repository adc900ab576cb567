// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/angle.h"

#include "core/geometry/frame_along.h"

namespace burin {
namespace {

constexpr double smallestSine = 1e-6;

} // namespace

glm::dvec3 turnedTowards(const glm::dvec3& from, const glm::dvec3& to, double most) noexcept {
    if (angleBetween(from, to) <= most) return to;
    const glm::dvec3 towards = to - from * glm::dot(from, to);
    const double sine = glm::length(towards);
    const glm::dvec3 side = sine > smallestSine ? towards / sine : anyAcross(from);
    return glm::normalize(from * std::cos(most) + side * std::sin(most));
}

} // namespace burin
