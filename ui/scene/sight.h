// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <optional>

namespace burin {

/// A sight line: a ray from the eye, or from far in front of everything in a parallel view; setup frame.
struct Sight {
    glm::dvec3 origin{0.0};               ///< mm
    glm::dvec3 direction{0.0, 0.0, -1.0}; ///< unit
    bool parallel = false; ///< whether all sight lines of the view have this direction, each with its own origin
    double seenFrom = 0.0; ///< mm from the origin: anything nearer is cut away in the picture

    /// The point where the visible part of the sight line begins, mm.
    glm::dvec3 seenOrigin() const noexcept { return origin + seenFrom * direction; }
};

/// The position along an axis (unit, through `place`) that is closest to a sight line, mm; std::nullopt if the sight
/// line is parallel to the axis.
inline std::optional<double> alongAxis(const Sight& sight, const glm::dvec3& place, const glm::dvec3& axis) noexcept {
    constexpr double smallestSine = 1e-3;
    const double cosine = glm::dot(sight.direction, axis), square = 1.0 - cosine * cosine;
    if (square < smallestSine * smallestSine) return std::nullopt;
    const glm::dvec3 between = sight.origin - place;
    return (glm::dot(between, axis) - cosine * glm::dot(between, sight.direction)) / square;
}

} // namespace burin
