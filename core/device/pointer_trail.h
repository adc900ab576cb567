// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/upright.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>

namespace burin {

/// The line through a pointer's goals. It grows at its end while a follower passes its points from the beginning.
///
/// A goal with a grain comes from a pointer of that resolution, such as the pixels of a screen: a slanted stroke
/// arrives as a staircase. There the line is the moving mean of the goals within three pixels to both sides (fewer near
/// corners, the start and the end), and only deviations from it that are larger than the pixel size explains are
/// treated as corners, at which the speed is reduced. The line ends at the newest goal. Thread: one; no lock, no
/// allocation.
class PointerTrail {
public:
    static constexpr std::size_t capacity = 1024; ///< points that are not passed yet
    static constexpr double meanTime = 0.016;     ///< s: a follower takes the mean of its position over this time
    static constexpr double tolerance = 0.05;     ///< mm by which this mean may deviate from the line at a corner

    struct Point {
        glm::dvec3 place{0.0};
        double length = 0.0; ///< mm, from the previous point
        double speed = 0.0;  ///< mm/s at which it may be passed; 0 at the line's end
    };

    void begin(const glm::dvec3& start, const glm::dvec3& axis = uprightAxis) noexcept; ///< mm; unit
    /// @param goal mm; @param grain mm: goals closer together than this can't be distinguished; 0: the goal is exact
    /// @param axis unit: the tool axis at the goal. A goal at the position of the previous one only changes its axis.
    /// @return false if there is no room; nothing is changed then
    bool append(const glm::dvec3& goal, double grain, const glm::dvec3& axis = uprightAxis) noexcept;

    std::size_t ahead() const noexcept { return newest_ + 1 - next_; } ///< points that are not passed yet
    /// @param index 0: the next point to be passed
    const Point& point(std::size_t index) const noexcept { return goal(next_ + index).point; }
    double lengthBeyond() const noexcept { return beyond_; } ///< mm, from the next point to the line's end
    const glm::dvec3& end() const noexcept { return goal(newest_).place; }
    /// The tool axis of a follower at a position between the point passed last and the next one: interpolated; unit.
    glm::dvec3 axisAt(const glm::dvec3& place) const noexcept;
    void pass() noexcept; ///< Passes the next point; its position does not change any more
    void passAll() noexcept;

private:
    static constexpr std::size_t kept = 2 * capacity; // goals, half of them passed
    static constexpr std::size_t scales = 8;          // of the compasses that detect corners

    struct Goal {
        glm::dvec3 place{0.0};
        glm::dvec3 axis = uprightAxis;
        double grain = 0.0;
        double arc = 0.0;       // mm along the goals, from the start
        glm::dvec3 moment{0.0}; // mm²: the line through the goals, integrated over the arc length
        double turnSpeed = 0.0; // mm/s: the limit set by the corners found
        double reach = 0.0;     // mm: the largest half width of the moving mean that corners allow
        double window = 0.0;    // mm: the half width of the moving mean
        Point point;
    };
    Goal& goal(std::size_t number) noexcept { return goals_[number % kept]; }
    const Goal& goal(std::size_t number) const noexcept { return goals_[number % kept]; }
    std::size_t oldest() const noexcept { return newest_ < kept ? 0 : newest_ + 1 - kept; }
    template <class Value>
    Value along(std::size_t number, double distance, Value (*between)(const Goal&, const Goal&, double)) const noexcept;
    glm::dvec3 placeBeside(std::size_t number, double distance) const noexcept;
    glm::dvec3 momentBeside(std::size_t number, double distance) const noexcept;
    void findCorners() noexcept;
    void judge(std::size_t number, std::size_t scale, double width) noexcept;
    void shape() noexcept;
    std::size_t firstToShape() const noexcept;
    double widestWindow(std::size_t number) const noexcept;
    void place(std::size_t number) noexcept;
    void limitSpeed(std::size_t number) noexcept;

    std::array<Goal, kept> goals_; // indexed by the goal's number modulo `kept`; number 0 is the start
    std::size_t next_ = 1, newest_ = 0;
    double beyond_ = 0.0;
    std::array<std::size_t, scales> judged_{}; // for each scale, the next goal to be checked
};

} // namespace burin
