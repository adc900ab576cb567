// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cmath>

namespace burin {

/// A rotation about a vertical axis.
class UprightTurn {
public:
    /// @param angle rad, anticlockwise seen from above
    UprightTurn(const glm::dvec3& centre, double angle)
        : centre_(centre), cosine_(std::cos(angle)), sine_(std::sin(angle)) {}

    glm::dvec3 turned(const glm::dvec3& place) const noexcept {
        const double x = place.x - centre_.x, y = place.y - centre_.y;
        return {centre_.x + cosine_ * x - sine_ * y, centre_.y + sine_ * x + cosine_ * y, place.z};
    }

private:
    glm::dvec3 centre_;
    double cosine_, sine_;
};

} // namespace burin
