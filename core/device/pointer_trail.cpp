// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/device/pointer_trail.h"

#include "core/geometry/segment.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin {
namespace {

constexpr double shortest = 1e-4; // mm between two goals
constexpr double unlimited = std::numeric_limits<double>::infinity();

// A grain is the diagonal of a pixel; the goals of a straight line lie within a band of that width.
constexpr double unexplained = 1.06; // grains by which a corner has to stand out
constexpr double widestMean = 2.1;   // grains to each side: the largest half width of the moving mean
constexpr double lookahead = 3.0; // multiple of the mean's half width: how far the line has to be known beyond a point
constexpr double smallestScale = 1.75; // grains, an arm of the smallest compass; each further compass is twice as wide
// corners found at these scales are kept sharp; those at wider scales look as if caused by pixels
constexpr std::size_t sharpScales = 2;
constexpr double widestArm = 3.2;       // mm: half of the length that a mean at the greatest speed covers
constexpr std::size_t mostShaped = 64;  // points reshaped per goal
constexpr double turning = 2800.0;      // mm/s² across the line; the follower uses the remaining acceleration along it
constexpr double ofExact = 0.75 * 0.05; // mm; the remaining tolerance is for accelerating behind the corner
// mm, twice the share that the mean over positions uses of it
constexpr double ofSharp = 0.6 * 0.05, ofMean = 0.3 * 0.05;

static_assert(PointerTrail::tolerance == 0.05);

/// The sine of half of the angle between two directions.
double halfTurn(const glm::dvec3& in, const glm::dvec3& out) noexcept {
    const double lengths = glm::length(in) * glm::length(out);
    return lengths > 0.0 ? std::sqrt(std::max(0.0, 0.5 * (1.0 - glm::dot(in, out) / lengths))) : 0.0;
}

double radiusOf(const glm::dvec3& in, const glm::dvec3& out, double half) noexcept {
    return 0.25 * (glm::length(in) + glm::length(out)) / half;
}

/// The highest speed past a corner for which the mean over a time deviates from it by at most a tolerance. The
/// deviation is v T sin(turn / 2) / 4 at a sharp corner, and (v T)² / (24 r) at one of many corners on an arc of radius
/// r.
double cornerSpeed(const glm::dvec3& in, const glm::dvec3& out, double tolerance) noexcept {
    constexpr double time = PointerTrail::meanTime;
    const double half = halfTurn(in, out);
    if (half < 1e-6) return unlimited;
    return std::min(4.0 * tolerance / (time * half), std::sqrt(24.0 * tolerance * radiusOf(in, out, half)) / time);
}

} // namespace

void PointerTrail::begin(const glm::dvec3& start, const glm::dvec3& axis) noexcept {
    newest_ = 0;
    next_ = 1;
    beyond_ = 0.0;
    judged_.fill(1);
    goal(0) = Goal{};
    goal(0).place = goal(0).point.place = start;
    goal(0).axis = axis;
}

bool PointerTrail::append(const glm::dvec3& place, double grain, const glm::dvec3& axis) noexcept {
    Goal& last = goal(newest_);
    const double length = glm::distance(last.place, place);
    if (length < shortest) {
        last.axis = axis;
        return true;
    }
    if (ahead() == capacity) return false;
    Goal& added = goal(newest_ + 1);
    added.place = place;
    added.axis = axis;
    added.grain = grain;
    added.arc = last.arc + length;
    added.moment = last.moment + 0.5 * length * (last.place + place);
    added.turnSpeed = added.reach = unlimited;
    added.window = 0.0;
    added.point = {place, glm::distance(last.point.place, place), 0.0};
    ++newest_;
    if (ahead() > 1) {
        beyond_ += added.point.length;
        limitSpeed(newest_ - 1);
    }
    findCorners();
    if (grain > 0.0) shape();
    return true;
}

void PointerTrail::pass() noexcept {
    ++next_;
    beyond_ = ahead() > 1 ? beyond_ - point(0).length : 0.0;
}

void PointerTrail::passAll() noexcept {
    next_ = newest_ + 1;
    beyond_ = 0.0;
}

glm::dvec3 PointerTrail::axisAt(const glm::dvec3& place) const noexcept {
    if (ahead() == 0) return goal(newest_).axis;
    const Goal &from = goal(next_ - 1), &to = goal(next_);
    if (from.axis == to.axis || !(to.point.length > 0.0)) return to.axis;
    const double share = 1.0 - std::min(1.0, glm::distance(place, to.point.place) / to.point.length);
    const glm::dvec3 axis = glm::mix(from.axis, to.axis, share);
    return glm::length(axis) > 0.0 ? glm::normalize(axis) : to.axis; // opposite axes have no mean
}

/// The value at a distance along the goals from one of them, backwards if it is negative; the nearest known value
/// beyond the ends.
template <class Value>
Value PointerTrail::along(std::size_t number, double distance,
                          Value (*between)(const Goal&, const Goal&, double)) const noexcept {
    const double arc = goal(number).arc + distance;
    if (distance < 0.0) {
        while (number > oldest() && goal(number - 1).arc > arc) --number;
        if (number == oldest()) return between(goal(number), goal(number), 0.0);
        return between(goal(number - 1), goal(number), arc - goal(number - 1).arc);
    }
    while (number < newest_ && goal(number + 1).arc < arc) ++number;
    if (number == newest_) return between(goal(number), goal(number), 0.0);
    return between(goal(number), goal(number + 1), arc - goal(number).arc);
}

glm::dvec3 PointerTrail::placeBeside(std::size_t number, double distance) const noexcept {
    return along<glm::dvec3>(number, distance, [](const Goal& from, const Goal& to, double way) {
        return way > 0.0 ? glm::mix(from.place, to.place, way / (to.arc - from.arc)) : from.place;
    });
}

glm::dvec3 PointerTrail::momentBeside(std::size_t number, double distance) const noexcept {
    return along<glm::dvec3>(number, distance, [](const Goal& from, const Goal& to, double way) {
        if (way <= 0.0) return from.moment;
        const glm::dvec3 there = glm::mix(from.place, to.place, way / (to.arc - from.arc));
        return from.moment + 0.5 * way * (from.place + there);
    });
}

/// Each compass is placed on every goal once, as soon as the line is known as far as the compass is wide.
void PointerTrail::findCorners() noexcept {
    for (std::size_t scale = 0; scale < scales; ++scale) {
        std::size_t& number = judged_[scale];
        for (number = std::max(number, next_); number < newest_; ++number) {
            const double width = goal(number).grain * smallestScale * static_cast<double>(1U << scale);
            if (width == 0.0 || 0.5 * width > widestArm) continue;
            if (goal(newest_).arc - goal(number).arc < width) break;
            judge(number, scale, width);
        }
    }
}

void PointerTrail::judge(std::size_t number, std::size_t scale, double width) noexcept {
    Goal& corner = goal(number);
    const glm::dvec3 from = placeBeside(number, -width), to = placeBeside(number, width);
    if (distanceToSegment(corner.place, from, to) <= unexplained * corner.grain) return;
    const glm::dvec3 in = corner.place - from, out = to - corner.place;
    const double half = halfTurn(in, out);
    double speed = 0.0;
    if (scale < sharpScales) {
        speed = cornerSpeed(in, out, ofSharp);
        corner.reach = std::min(corner.reach, ofMean / half);
    } else {
        // The next smaller compass found no corner here: a mean over its width deviates by less than a pixel.
        const double rest =
            std::max(tolerance, 0.7 * corner.grain) - 0.3 * corner.grain; // used by the mean over positions
        speed = std::max(cornerSpeed(in, out, 0.75 * rest), 0.7 * width / meanTime);
        speed = std::min(speed, std::sqrt(turning * radiusOf(in, out, half)));
    }
    corner.turnSpeed = std::min(corner.turnSpeed, speed);
    limitSpeed(number);
}

/// The next point to be passed keeps its position, so that a follower is never led back.
std::size_t PointerTrail::firstToShape() const noexcept {
    const double since = goal(newest_).arc - lookahead * widestMean * goal(newest_).grain;
    std::size_t first = newest_;
    while (first > next_ + 1 && newest_ - first < mostShaped && goal(first - 1).arc > since) --first;
    return std::max(first, next_ + 1);
}

double PointerTrail::widestWindow(std::size_t number) const noexcept {
    const Goal& at = goal(number);
    const double known = (goal(newest_).arc - at.arc) / lookahead;
    return std::min({widestMean * at.grain, known, at.arc, at.reach});
}

/// From one point to the next, the mean's window changes by no more than the distance between them, so that the line
/// never goes back where the goals don't.
void PointerTrail::shape() noexcept {
    const std::size_t first = firstToShape();
    double widest = 0.0;
    for (std::size_t number = newest_; number >= first; --number) {
        const double way = number < newest_ ? goal(number + 1).arc - goal(number).arc : 0.0;
        widest = std::min(widestWindow(number), widest + way);
        goal(number).window = widest;
    }
    for (std::size_t number = first; number <= newest_; ++number) {
        const double way = goal(number).arc - goal(number - 1).arc, before = goal(number - 1).window;
        const double known = goal(newest_).arc - goal(number).arc;
        goal(number).window = std::min(std::clamp(goal(number).window, before - way, before + way), known);
        place(number);
    }
    for (std::size_t number = std::max(first - 1, next_); number < newest_; ++number) limitSpeed(number);
}

void PointerTrail::place(std::size_t number) noexcept {
    Goal& at = goal(number);
    const double window = at.window;
    at.point.place =
        window < shortest ? at.place : (momentBeside(number, window) - momentBeside(number, -window)) / (2.0 * window);
    const double length = glm::distance(goal(number - 1).point.place, at.point.place);
    beyond_ += length - at.point.length;
    at.point.length = length;
}

/// For a point that has a successor.
void PointerTrail::limitSpeed(std::size_t number) noexcept {
    Goal& at = goal(number);
    const glm::dvec3 in = at.point.place - goal(number - 1).point.place;
    const glm::dvec3 out = goal(number + 1).point.place - at.point.place;
    const double half = halfTurn(in, out);
    const double bySteps = half < 1e-6 ? unlimited : 0.5 * turning * meanTime / half;
    at.point.speed = at.grain > 0.0 ? std::min(at.turnSpeed, bySteps) : cornerSpeed(in, out, ofExact);
}

} // namespace burin
