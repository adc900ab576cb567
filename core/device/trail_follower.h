// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/pointer_trail.h"

#include <array>
#include <cstddef>

namespace burin {

/// Follows the line through a pointer's goals (pointer_trail.h) while it grows, along the line and not across its
/// corners. The position is the mean, over 16 ms, of a point that goes along the line: it never goes back, its speed
/// and acceleration are bounded, and it leaves the goals by at most `tolerance` at a corner, which is slowed down for.
/// What no pixel tells from a straight or smoothly bent line is none: there it is within a grain of the goals. Thread:
/// one; no lock, no allocation.
class TrailFollower {
public:
    static constexpr double tolerance = PointerTrail::tolerance; ///< mm from the line, at its corners
    static constexpr double acceleration = 4000.0;               ///< mm/s² along the line

    void begin(const glm::dvec3& start) noexcept;               ///< mm; at rest there
    bool append(const glm::dvec3& goal, double grain) noexcept; ///< as PointerTrail::append

    /// Goes on by a time. @param seconds at least 0 @param maximumSpeed mm/s along the line
    /// @return where it is, mm
    glm::dvec3 step(double seconds, double maximumSpeed) noexcept;
    const glm::dvec3& velocity() const noexcept { return velocity_; } ///< mm/s
    std::size_t ahead() const noexcept { return trail_.ahead(); }     ///< points that are not passed
    bool finished() const noexcept;                                   ///< it rests at the line's end

private:
    static constexpr std::size_t window = 16; // ticks that the position is the mean of

    double aheadLength() const noexcept;
    double speedLimit() const noexcept;
    void advance(double way) noexcept;
    void tick(double maximumSpeed) noexcept;

    PointerTrail trail_;
    glm::dvec3 carrier_{0.0}; // what goes along the line, mm
    double speed_ = 0.0;      // mm/s
    std::array<glm::dvec3, window> recent_{};
    std::size_t oldest_ = 0;
    std::size_t resting_ = 0; // ticks since it came to rest
    glm::dvec3 before_{0.0}, mean_{0.0}, velocity_{0.0};
    double time_ = 0.0; // s since the last tick
};

} // namespace burin
