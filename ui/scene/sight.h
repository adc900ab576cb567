// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <optional>

namespace burin {

/// A half-line from the eye, or from far before everything in a parallel picture; setup frame.
struct Sight {
    glm::dvec3 origin{0.0};               ///< mm
    glm::dvec3 direction{0.0, 0.0, -1.0}; ///< unit
    bool parallel = false;                ///< all sights of the picture have this direction, and origins of their own
    double seenFrom = 0.0;                ///< mm from the origin: what lies before is cut away in the picture

    /// Where what is seen begins, mm.
    glm::dvec3 seenOrigin() const noexcept { return origin + seenFrom * direction; }
};

/// How far along an axis (unit) through a place a sight passes it nearest, mm. Nothing where it runs along the axis.
inline std::optional<double> alongAxis(const Sight& sight, const glm::dvec3& place, const glm::dvec3& axis) noexcept {
    constexpr double smallestSine = 1e-3;
    const double cosine = glm::dot(sight.direction, axis), square = 1.0 - cosine * cosine;
    if (square < smallestSine * smallestSine) return std::nullopt;
    const glm::dvec3 between = sight.origin - place;
    return (glm::dot(between, axis) - cosine * glm::dot(between, sight.direction)) / square;
}

} // namespace burin
