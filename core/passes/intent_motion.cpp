// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/passes/intent_motion.h"

#include "core/base/numbers.h"
#include "core/geometry/pose.h"

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

struct Segment {
    glm::dvec3 direction{0.0};
    double length = 0.0;
    double speed = 0.0;
};

Error invalid(const std::string& what, const std::string& value, const std::string& allowed) {
    return {ErrorCode::argumentInvalid, what, value, allowed};
}

bool positive(double value) {
    return std::isfinite(value) && value > 0.0;
}

Result<std::vector<Segment>> segments(std::span<const IntentPoint> points, const MotionLimits& limits) {
    if (points.empty()) return invalid("intent", "0 points", "at least one point");
    std::vector<Segment> result;
    result.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::string name = "intent point " + std::to_string(i + 1);
        if (!isFinite(points[i].tip)) return invalid(name, "tip", "finite coordinates");
        if (i == 0) continue;
        if (!positive(points[i].speed)) return invalid(name, formatShortest(points[i].speed), "a speed above 0");
        const glm::dvec3 step = points[i].tip - points[i - 1].tip;
        const double length = glm::length(step);
        if (length < 1e-9) continue; // the same point twice: no direction, no time
        result.push_back({step / length, length, std::min(points[i].speed, limits.maximumSpeed)});
    }
    return result;
}

constexpr double turningShare = 0.5; // of the acceleration; the remainder is for the change of speed along the move

/// The greatest speed around the corner between two segments: the change of velocity, spread over the time in which a
/// corner is rounded, stays within a share of the acceleration, and so does the curvature that a sequence of short
/// segments approximates.
double cornerSpeed(const Segment& in, const Segment& out, const MotionLimits& limits) {
    const double turn =
        std::atan2(glm::length(glm::cross(in.direction, out.direction)), glm::dot(in.direction, out.direction));
    const double speed = std::min(in.speed, out.speed);
    if (turn < 1e-9) return speed;
    const double turning = turningShare * limits.acceleration;
    const double byChange = turning * limits.cornerSeconds / (2.0 * std::sin(0.5 * turn));
    const double byCurvature = std::sqrt(turning * 0.5 * (in.length + out.length) / turn);
    return std::min({speed, byChange, byCurvature});
}

/// The speeds at the ends of the segments that acceleration and braking allow; at rest at both ends.
std::vector<double> endSpeeds(const std::vector<Segment>& way, const MotionLimits& limits) {
    std::vector<double> speeds(way.size() + 1, 0.0);
    for (std::size_t i = 1; i < way.size(); ++i) speeds[i] = cornerSpeed(way[i - 1], way[i], limits);
    const auto reachable = [&](double from, const Segment& over) {
        return std::sqrt(from * from + 2.0 * limits.acceleration * over.length);
    };
    for (std::size_t i = 0; i < way.size(); ++i) speeds[i + 1] = std::min(speeds[i + 1], reachable(speeds[i], way[i]));
    for (std::size_t i = way.size(); i-- > 0;) speeds[i] = std::min(speeds[i], reachable(speeds[i + 1], way[i]));
    return speeds;
}

} // namespace

Result<IntentMotion> IntentMotion::make(std::span<const IntentPoint> points, const MotionLimits& limits) {
    for (const double limit : {limits.acceleration, limits.cornerSeconds, limits.maximumSpeed})
        if (!positive(limit)) return invalid("motion limit", formatShortest(limit), "a number above 0");
    const Result<std::vector<Segment>> way = segments(points, limits);
    if (!way) return way.error();

    IntentMotion motion(limits);
    motion.origin_ = points.front().tip;
    motion.phases_.reserve(way->size() + 1);
    const std::vector<double> speeds = endSpeeds(*way, limits);
    for (std::size_t i = 0; i < way->size(); ++i)
        motion.append((*way)[i].direction, (*way)[i].length, speeds[i], (*way)[i].speed, speeds[i + 1]);
    // Sums of thousands of short pieces may miss the last point by some 1e-10 mm; the end is set to be exact.
    motion.end_.position = points.back().tip - motion.origin_;
    motion.end_.velocity = glm::dvec3(0.0);
    return motion;
}

void IntentMotion::append(const glm::dvec3& direction, double length, double entry, double cruise, double exit) {
    const glm::dvec3 goal = end_.position + direction * length;
    const double a = limits_.acceleration;
    const double peak = std::min(cruise, std::sqrt(0.5 * (2.0 * a * length + entry * entry + exit * exit)));
    const double speedingUp = std::max(0.0, 0.5 * (peak * peak - entry * entry) / a);
    const double braking = std::max(0.0, 0.5 * (peak * peak - exit * exit) / a);
    appendPhase(direction, entry, a, (peak - entry) / a);
    appendPhase(direction, peak, 0.0, (length - speedingUp - braking) / peak);
    appendPhase(direction, peak, -a, (peak - exit) / a);
    end_.position = goal;
}

void IntentMotion::appendPhase(const glm::dvec3& direction, double speed, double acceleration, double seconds) {
    if (!(seconds > 1e-12)) return;
    phases_.push_back({travelSeconds_, end_.position, end_.integral, direction, speed, acceleration});
    travelSeconds_ += seconds;
    const double t = seconds;
    end_.integral += end_.position * t + direction * (t * t * (0.5 * speed + acceleration * t / 6.0));
    end_.position += direction * (t * (speed + 0.5 * acceleration * t));
}

IntentMotion::Moment IntentMotion::unrounded(double time) const noexcept {
    if (time <= 0.0) return {};
    if (time >= travelSeconds_) return {end_.integral + end_.position * (time - travelSeconds_), end_.position, {}};
    const auto after = std::upper_bound(phases_.begin(), phases_.end(), time,
                                        [](double t, const Phase& phase) { return t < phase.start; });
    const Phase& phase = *std::prev(after);
    const double t = time - phase.start;
    return {phase.integral + phase.position * t +
                phase.direction * (t * t * (0.5 * phase.speed + phase.acceleration * t / 6.0)),
            phase.position + phase.direction * (t * (phase.speed + 0.5 * phase.acceleration * t)),
            phase.direction * (phase.speed + phase.acceleration * t)};
}

MotionState IntentMotion::at(double time) const noexcept {
    const Moment now = unrounded(time);
    const Moment before = unrounded(time - limits_.cornerSeconds);
    const double window = limits_.cornerSeconds;
    if (time <= 0.0) return {origin_, {}, {}};
    if (time >= duration()) return {origin_ + end_.position, {}, {}};
    return {origin_ + (now.integral - before.integral) / window, (now.position - before.position) / window,
            (now.velocity - before.velocity) / window};
}

} // namespace burin
