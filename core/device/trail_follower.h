// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/pointer_trail.h"

#include <array>
#include <cstddef>

namespace burin {

/// Follows the line through a pointer's goals (pointer_trail.h) while it grows, without cutting across its corners. The
/// position is the mean, over 16 ms, of a point that moves along the line: it never moves back, its speed and
/// acceleration are bounded, and at corners the speed is reduced so that it deviates from the goals by at most
/// `tolerance`. A deviation from a straight or smoothly bent line that the pixel size explains is not a corner: there
/// the position stays within a grain of the goals. One thread; no lock, no allocation.
class TrailFollower {
public:
    static constexpr double tolerance = PointerTrail::tolerance; ///< mm from the line, at its corners
    static constexpr double acceleration = 4000.0;               ///< mm/s² along the line

    void begin(const glm::dvec3& start, const glm::dvec3& axis = uprightAxis) noexcept; ///< mm; at rest there
    /// As PointerTrail::append.
    bool append(const glm::dvec3& goal, double grain, const glm::dvec3& axis = uprightAxis) noexcept;

    /// Advances by a time. @param seconds at least 0 @param maximumSpeed mm/s along the line
    /// @return the position, mm
    glm::dvec3 step(double seconds, double maximumSpeed) noexcept;
    const glm::dvec3& velocity() const noexcept { return velocity_; } ///< mm/s
    /// The tool axis at the position, unit: interpolated between those of the goals.
    glm::dvec3 axis() const noexcept { return trail_.axisAt(carrier_); }
    std::size_t ahead() const noexcept { return trail_.ahead(); } ///< points that are not passed yet
    bool finished() const noexcept;                               ///< whether it rests at the line's end

private:
    static constexpr std::size_t window = 16; // ticks over which the position is averaged

    double aheadLength() const noexcept;
    double speedLimit() const noexcept;
    void advance(double way) noexcept;
    void tick(double maximumSpeed) noexcept;

    PointerTrail trail_;
    glm::dvec3 carrier_{0.0}; // the point that moves along the line, mm
    double speed_ = 0.0;      // mm/s
    std::array<glm::dvec3, window> recent_{};
    std::size_t oldest_ = 0;
    std::size_t resting_ = 0; // ticks since it came to rest
    glm::dvec3 before_{0.0}, mean_{0.0}, velocity_{0.0};
    double time_ = 0.0; // s since the last tick
};

} // namespace burin
