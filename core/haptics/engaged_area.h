// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>

namespace burin {

/// The area engaged with the material: removed volume divided by distance moved, both smoothed over distance and not
/// over time. The rows of scanlines that cause its ripple are passed by the millimetre, whatever the hand's speed, and
/// a tool at rest keeps its last value. The distance is the net one, so that the encoder steps that make a staircase of
/// a slanted line count as the line; and it has some play, so that tremor smaller than that does not erase the value.
/// Two first-order filters in series. Called in the haptic tick.
class EngagedArea {
public:
    /// @param length mm of motion, constant of either filter. @param play mm by which the tool may move back and forth
    /// without effect
    EngagedArea(double length, double play) noexcept : length_(length), play_(play) {}

    /// @param volume mm³, removed in a tick. @param motion mm, of the same tick
    void add(double volume, const glm::dvec3& motion) noexcept {
        ahead_ += motion;
        waiting_ += volume;
        const double distance = glm::length(ahead_), way = distance - play_;
        if (!(way > 0.0)) return;
        const glm::dvec3 direction = ahead_ / distance;
        follow(waiting_ / way, direction, 1.0 - std::exp(-way / length_));
        ahead_ = play_ * direction;
        waiting_ = 0.0;
    }
    /// Lets the area decay while nothing can be engaged. @param seconds since the last tick
    void fade(double seconds) noexcept { follow(0.0, net_, 1.0 - std::exp(-seconds / fading)); }
    void reset() noexcept {
        first_ = area_ = waiting_ = 0.0;
        ahead_ = glm::dvec3(0.0);
    }
    double value() const noexcept { return area_ / std::max(glm::length(net_), straightest); } ///< mm²

private:
    static constexpr double fading = 0.015;  ///< s
    static constexpr double nothing = 1e-12; ///< mm²; an endless decay would reach denormal numbers, which are slow
    /// Net distance over distance of the most irregular staircase, along a cube's diagonal. A smaller ratio means that
    /// the hand moves back and forth.
    static constexpr double straightest = 0.577;

    void follow(double area, const glm::dvec3& direction, double share) noexcept {
        first_ += share * (area - first_);
        area_ += share * (first_ - area_);
        firstNet_ += share * (direction - firstNet_);
        net_ += share * (firstNet_ - net_);
        if (first_ < nothing) first_ = 0.0;
        if (area_ < nothing) area_ = 0.0;
    }
    double length_, play_;                ///< mm
    glm::dvec3 ahead_{0.0};               ///< mm, from the position that counts so far to the tool
    double waiting_ = 0.0;                ///< mm³, not yet assigned to a distance
    double first_ = 0.0, area_ = 0.0;     ///< mm²: volume over total distance
    glm::dvec3 firstNet_{0.0}, net_{0.0}; ///< net motion, as a vector, over total distance
};

} // namespace burin
