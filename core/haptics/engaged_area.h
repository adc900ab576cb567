// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>

namespace burin {

/// The area that meets the material: removed volume over the way, both smoothed over the way and not over time. The
/// rows of scanlines that make it ripple are passed by the millimetre, whatever the hand's speed; a tool that rests
/// keeps what it last met. The way is the net one, so that the steps of an encoder, which make a staircase of a slanted
/// line, count as the line; and it has some play, so that a hand that trembles by less forgets nothing. Two filters of
/// first order in a row. Tick code.
class EngagedArea {
public:
    /// @param length mm of way, of either filter. @param play mm, that the tool may go to and fro by
    EngagedArea(double length, double play) noexcept : length_(length), play_(play) {}

    /// @param volume mm³, removed in a tick. @param motion mm, of that tick
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
    /// Nothing can be met for so long. @param seconds since the last tick
    void fade(double seconds) noexcept { follow(0.0, net_, 1.0 - std::exp(-seconds / fading)); }
    void reset() noexcept {
        first_ = area_ = waiting_ = 0.0;
        ahead_ = glm::dvec3(0.0);
    }
    double value() const noexcept { return area_ / std::max(glm::length(net_), straightest); } ///< mm²

private:
    static constexpr double fading = 0.015;  ///< s
    static constexpr double nothing = 1e-12; ///< mm²; a decay without end would be in denormal numbers, which are slow
    /// Net way over way of the most crooked staircase, along a cube's diagonal. Less is a hand that goes to and fro.
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
    glm::dvec3 ahead_{0.0};               ///< mm, of the tool before what counts as its place
    double waiting_ = 0.0;                ///< mm³, for a way that counts
    double first_ = 0.0, area_ = 0.0;     ///< mm²: volume over all of the way
    glm::dvec3 firstNet_{0.0}, net_{0.0}; ///< way, as a vector, over all of the way
};

} // namespace burin
