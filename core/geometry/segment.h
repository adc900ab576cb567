// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <algorithm>

namespace burin {

/// The point of a straight segment that is nearest to another point, mm. @tparam Vector glm::dvec2 or glm::dvec3
template <class Vector>
Vector nearestOnSegment(const Vector& point, const Vector& from, const Vector& to) noexcept {
    const Vector along = to - from;
    const double square = glm::dot(along, along);
    const double part = square > 0.0 ? std::clamp(glm::dot(point - from, along) / square, 0.0, 1.0) : 0.0;
    return from + part * along;
}

/// Distance from a point to a straight segment, mm.
template <class Vector>
double distanceToSegment(const Vector& point, const Vector& from, const Vector& to) noexcept {
    return glm::distance(point, nearestOnSegment(point, from, to));
}

} // namespace burin
