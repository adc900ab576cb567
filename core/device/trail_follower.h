// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstddef>

namespace burin {

/// Follows a line of points that grows while it is followed, as a pointer's goals do, along the line and not across its
/// corners. The position is the mean, over 16 ms, of a point that goes along the line: it never goes back, its speed
/// and acceleration are bounded, and it leaves the line by at most `tolerance` at a corner, which is slowed down for.
/// Thread: one; no lock, no allocation.
class TrailFollower {
public:
    static constexpr std::size_t capacity = 1024;  ///< points that are not reached yet
    static constexpr double tolerance = 0.05;      ///< mm from the line, at its corners
    static constexpr double acceleration = 4000.0; ///< mm/s² along the line

    void begin(const glm::dvec3& start) noexcept; ///< mm; at rest there
    /// @return false, and nothing changed, where there is no room
    bool append(const glm::dvec3& point) noexcept;

    /// Goes on by a time. @param seconds at least 0 @param maximumSpeed mm/s along the line
    /// @return where it is, mm
    glm::dvec3 step(double seconds, double maximumSpeed) noexcept;
    const glm::dvec3& velocity() const noexcept { return velocity_; } ///< mm/s
    std::size_t ahead() const noexcept { return count_; }             ///< points that are not passed
    bool finished() const noexcept;                                   ///< it rests at the line's end

private:
    static constexpr std::size_t window = 16; // ticks that the position is the mean of

    struct Corner {
        glm::dvec3 point{0.0};
        double length = 0.0; // mm, of the segment that leads to it
        double speed = 0.0;  // mm/s, at most, past it; 0 at the line's end
    };
    Corner& corner(std::size_t index) noexcept { return corners_[(first_ + index) % capacity]; }
    const Corner& corner(std::size_t index) const noexcept { return corners_[(first_ + index) % capacity]; }
    double speedLimit() const noexcept;
    void advance(double way) noexcept;
    void tick(double maximumSpeed) noexcept;

    std::array<Corner, capacity> corners_; // the next one to be reached first
    std::size_t first_ = 0, count_ = 0;
    glm::dvec3 last_{0.0};    // the newest point of the line, mm
    glm::dvec3 passed_{0.0};  // the last one that was passed, mm
    glm::dvec3 carrier_{0.0}; // what goes along the line, mm
    double ahead_ = 0.0;      // mm, to the line's end
    double speed_ = 0.0;      // mm/s
    std::array<glm::dvec3, window> recent_{};
    std::size_t oldest_ = 0;
    std::size_t resting_ = 0; // ticks since it came to rest
    glm::dvec3 before_{0.0}, mean_{0.0}, velocity_{0.0};
    double time_ = 0.0; // s since the last tick
};

} // namespace burin
