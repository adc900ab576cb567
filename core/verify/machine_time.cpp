// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/verify/machine_time.h"

#include "core/base/units.h"
#include "core/verify/speed_ramp.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace burin {

namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();
constexpr double straightOn = 1e-6; // of |change of direction| / 2: less is no corner

/// A block as the planner treats it. mm and s.
struct Block {
    std::size_t motion = 0;
    double length = 0.0;              ///< mm, > 0
    double speed = 0.0;               ///< mm/s, upper limit
    double acceleration = 0.0;        ///< mm/s² along it; infinite: no limit
    double jerk = 0.0;                ///< mm/s³ along it; infinite: no limit
    glm::dvec3 first{0.0}, last{0.0}; ///< unit vectors of the direction at both ends
    double entry = 0.0;               ///< mm²/s², square of the speed at its start
    bool startsAtRest = false;        ///< a dwell or a tool change precedes it
};

/// The greatest value along a direction that keeps every axis within its own limit.
template <class OfAxis>
double along(const glm::dvec3& direction, const OfAxis& ofAxis) {
    double most = unlimited;
    for (int axis = 0; axis < 3; ++axis)
        if (std::abs(direction[axis]) > 1e-12) most = std::min(most, ofAxis(axis) / std::abs(direction[axis]));
    return most;
}

double accelerationOf(const MachineProfile& machine, int axis) {
    const double acceleration = machine.axisAcceleration(axis);
    return acceleration > 0.0 ? acceleration : unlimited;
}
double jerkOf(const MachineProfile& machine, int axis) {
    return machine.axisJerks[axis] > 0.0 ? machine.axisJerks[axis] : unlimited;
}
double rateOf(const MachineProfile& machine, int axis) { // mm/s
    const double rate = machine.axisRate(axis);
    return rate > 0.0 ? rate / secondsPerMinute : unlimited;
}

class Planner {
public:
    Planner(const ParsedProgram& program, const MachineProfile& machine)
        : program_(program), machine_(machine), alone_(program.motions.size()) {
        time_.motions.resize(program.motions.size());
    }

    MachiningTime plan() {
        for (std::size_t i = 0; i < program_.motions.size(); ++i) add(i);
        limitEntries();
        std::vector<double> durations = alone_;
        for (std::size_t i = 0; i < blocks_.size(); ++i) {
            const Block& block = blocks_[i];
            const RampTime ramp =
                trapezoid(block.length, std::sqrt(block.entry), std::sqrt(exitOf(i)), block.speed, block.acceleration);
            durations[block.motion] = ramp.seconds;
            time_.motions[block.motion].peakSpeed = ramp.peak;
        }
        limitJerk(durations);
        double now = 0.0;
        for (std::size_t i = 0; i < durations.size(); ++i) {
            if (changesTool(i)) now += machine_.toolChangeSeconds;
            time_.motions[i].start = now;
            time_.motions[i].duration = durations[i];
            now += durations[i];
        }
        time_.seconds = now;
        return std::move(time_);
    }

private:
    bool changesTool(std::size_t i) const {
        const int before = i == 0 ? 0 : program_.motions[i - 1].tool;
        return program_.motions[i].tool != before;
    }

    void add(std::size_t i) {
        const NcMotion& motion = program_.motions[i];
        if (changesTool(i)) {
            ++time_.toolChanges;
            atRest_ = true;
        }
        const bool known = motion.startKnown() && motion.endKnown();
        if (motion.kind == NcMotionKind::dwell) {
            alone_[i] = motion.seconds;
            atRest_ = true;
            time_.withoutAcceleration += motion.seconds;
        } else if (!known) {
            ++time_.untimedMoves;
            atRest_ = true;
        } else if (motion.rapid() && machine_.rapids == RapidMode::independent) {
            addIndependent(i);
        } else {
            addBlock(i);
        }
    }

    /// Every axis moves independently, from rest to rest.
    void addIndependent(std::size_t i) {
        const NcMotion& motion = program_.motions[i];
        double longest = 0.0, atRates = 0.0;
        for (int axis = 0; axis < 3; ++axis) {
            const double way = std::abs(motion.to[linearAxis(axis)] - motion.from[linearAxis(axis)]);
            if (!(way > 0.0) || !std::isfinite(rateOf(machine_, axis))) continue;
            const RampTime ramp =
                sCurve(way, 0.0, 0.0, rateOf(machine_, axis), accelerationOf(machine_, axis), jerkOf(machine_, axis));
            longest = std::max(longest, ramp.seconds);
            atRates = std::max(atRates, way / rateOf(machine_, axis));
            time_.motions[i].peakSpeed = std::hypot(time_.motions[i].peakSpeed, ramp.peak);
        }
        alone_[i] = longest;
        time_.withoutAcceleration += atRates;
        atRest_ = true;
    }

    void addBlock(std::size_t i) {
        const NcMotion& motion = program_.motions[i];
        Block block;
        block.motion = i;
        block.length = lengthOf(motion);
        if (!(block.length > 0.0)) return addRotation(i);
        double asked = motion.rapid() ? unlimited : motion.feed / secondsPerMinute;
        if (motion.rapid() && (machine_.rapids == RapidMode::tip || motion.kind == NcMotionKind::arc))
            asked = machine_.rapidFeed / secondsPerMinute;
        if (motion.kind == NcMotionKind::arc)
            limitArc(motion, block);
        else
            limitStraight(motion, block);
        if (machine_.tilts()) limitRotation(motion, block);
        block.speed = std::min(block.speed, asked);
        if (machine_.blocksPerSecond > 0.0)
            block.speed = std::min(block.speed, block.length * machine_.blocksPerSecond);
        if (!(block.speed > 0.0) || !std::isfinite(block.speed)) { // no feed or no rate: the time is unknown
            atRest_ = true;
            return;
        }
        block.startsAtRest = atRest_;
        atRest_ = false;
        blocks_.push_back(block);
        time_.withoutAcceleration += block.length / (motion.rapid() ? block.speed : motion.feed / secondsPerMinute);
    }

    /// Only rotary axes move, from rest to rest.
    void addRotation(std::size_t i) {
        const NcMotion& motion = program_.motions[i];
        double longest = 0.0, atRates = 0.0;
        for (const RotaryAxis& axis : machine_.rotaryAxes) {
            const double way = std::abs(motion.to[axis.axis] - motion.from[axis.axis]);
            const double rate =
                std::min(axis.rate > 0.0 ? axis.rate : unlimited, motion.rapid() ? unlimited : motion.feed);
            if (!(way > 0.0) || !std::isfinite(rate) || !(rate > 0.0)) continue;
            const double acceleration = axis.acceleration > 0.0 ? axis.acceleration : unlimited;
            longest = std::max(longest, trapezoid(way, 0.0, 0.0, rate / secondsPerMinute, acceleration).seconds);
            atRates = std::max(atRates, way / (rate / secondsPerMinute));
        }
        if (!(longest > 0.0)) return;
        alone_[i] = longest;
        time_.withoutAcceleration += atRates;
        atRest_ = true;
    }

    /// Speed and acceleration at which no rotary axis exceeds its own.
    void limitRotation(const NcMotion& motion, Block& block) const {
        for (const RotaryAxis& axis : machine_.rotaryAxes) {
            const double turn = std::abs(motion.to[axis.axis] - motion.from[axis.axis]) / block.length; // degrees/mm
            if (!(turn > 1e-12)) continue;
            if (axis.rate > 0.0) block.speed = std::min(block.speed, axis.rate / secondsPerMinute / turn);
            if (axis.acceleration > 0.0) block.acceleration = std::min(block.acceleration, axis.acceleration / turn);
        }
    }

    void limitStraight(const NcMotion& motion, Block& block) const {
        block.first = block.last = (motion.to.linear() - motion.from.linear()) / block.length;
        block.speed = along(block.first, [&](int axis) { return rateOf(machine_, axis); });
        block.acceleration = along(block.first, [&](int axis) { return accelerationOf(machine_, axis); });
        block.jerk = along(block.first, [&](int axis) { return jerkOf(machine_, axis); });
    }

    /// An arc passes through all directions of its plane: the least values of its axes apply, whatever its sweep.
    void limitArc(const NcMotion& motion, Block& block) const {
        const ArcTurn turn = motion.turn();
        const int axis = motion.arcAxis, u = (axis + 1) % 3, v = (axis + 2) % 3;
        const double rise = (motion.to[linearAxis(axis)] - motion.from[linearAxis(axis)]) / block.length;
        const double inPlane = std::sqrt(std::max(0.0, 1.0 - rise * rise));
        const auto tangent = [&](double angle) {
            glm::dvec3 direction(0.0);
            const double sense = turn.sweep < 0.0 ? -1.0 : 1.0;
            direction[u] = -sense * inPlane * std::sin(angle);
            direction[v] = sense * inPlane * std::cos(angle);
            direction[axis] = rise;
            return direction;
        };
        block.first = tangent(turn.startAngle);
        block.last = tangent(turn.startAngle + turn.sweep);
        glm::dvec3 widest(0.0);
        widest[u] = widest[v] = inPlane;
        widest[axis] = rise;
        block.speed = along(widest, [&](int i) { return rateOf(machine_, i); });
        block.acceleration = along(widest, [&](int i) { return accelerationOf(machine_, i); });
        block.jerk = along(widest, [&](int i) { return jerkOf(machine_, i); });
        const double centripetal = std::min(accelerationOf(machine_, u), accelerationOf(machine_, v));
        const double radius = std::min(turn.startRadius, turn.endRadius);
        if (std::isfinite(centripetal) && inPlane > 0.0)
            block.speed = std::min(block.speed, std::sqrt(centripetal * radius) / inPlane);
    }

    /// Square of the speed that the machine's rule allows between two blocks.
    double junction(const Block& before, const Block& after) const {
        const glm::dvec3 change = after.first - before.last;
        const double half = 0.5 * glm::length(change);            // cosine of half of the inner angle
        const NcMotion& motion = program_.motions[before.motion]; // the mode in force at a block applies to its end
        const bool stated = motion.pathMode != PathMode::machine;
        const bool stops = motion.pathMode == PathMode::exactStop;
        if (stops || (!stated && machine_.junctions == JunctionRule::exactStop)) return 0.0;
        if (half < straightOn) return unlimited;
        if (motion.pathMode == PathMode::exactPath) return 0.0;
        const double acceleration =
            along(change / (2.0 * half), [&](int axis) { return accelerationOf(machine_, axis); });
        if (!std::isfinite(acceleration)) return unlimited;
        if (!stated && machine_.junctions == JunctionRule::deviation) {
            const double sine = std::sqrt(std::max(0.0, 1.0 - half * half)); // of half of the inner angle
            return acceleration * machine_.junctionTolerance * sine / (1.0 - sine);
        }
        const double tolerance = !stated                       ? machine_.junctionTolerance
                                 : motion.blendTolerance > 0.0 ? motion.blendTolerance
                                                               : unlimited;
        const double leg = std::min({2.0 * tolerance / half, 0.5 * before.length, 0.5 * after.length});
        return acceleration * leg / half;
    }

    /// Between two points of least speed, adds the extra time of one S-curve over the whole interval, distributed in
    /// proportion to the time.
    void limitJerk(std::vector<double>& durations) {
        const auto peakOf = [&](std::size_t i) { return time_.motions[blocks_[i].motion].peakSpeed; };
        for (std::size_t first = 0, end = 0; first < blocks_.size(); first = end) {
            double length = 0.0, planned = 0.0, peak = 0.0, acceleration = unlimited, jerk = unlimited;
            for (end = first; end < blocks_.size(); ++end) {
                const double entry = std::sqrt(blocks_[end].entry) * (1.0 + 1e-9);
                if (end > first && entry < peakOf(end - 1) && entry < peakOf(end)) break;
                length += blocks_[end].length;
                planned += durations[blocks_[end].motion];
                peak = std::max(peak, peakOf(end));
                acceleration = std::min(acceleration, blocks_[end].acceleration);
                jerk = std::min(jerk, blocks_[end].jerk);
            }
            if (!std::isfinite(jerk) || !std::isfinite(acceleration)) continue;
            const double from = std::sqrt(blocks_[first].entry), to = std::sqrt(exitOf(end - 1));
            const RampTime ramp = sCurve(length, from, to, peak, acceleration, jerk);
            const double added = ramp.seconds - trapezoid(length, from, to, peak, acceleration).seconds;
            if (!(added > 0.0)) continue;
            for (std::size_t i = first; i < end; ++i) {
                durations[blocks_[i].motion] *= 1.0 + added / planned;
                double& reached = time_.motions[blocks_[i].motion].peakSpeed;
                reached = std::min(reached, ramp.peak);
            }
        }
    }

    void limitEntries() {
        for (std::size_t i = 0; i < blocks_.size(); ++i) {
            Block& block = blocks_[i];
            if (i == 0 || block.startsAtRest) continue;
            const Block& before = blocks_[i - 1];
            block.entry = std::min({junction(before, block), before.speed * before.speed, block.speed * block.speed});
        }
        for (std::size_t i = blocks_.size(); i-- > 0;)
            blocks_[i].entry = std::min(blocks_[i].entry, exitOf(i) + reachOf(blocks_[i]));
        for (std::size_t i = 1; i < blocks_.size(); ++i)
            blocks_[i].entry = std::min(blocks_[i].entry, blocks_[i - 1].entry + reachOf(blocks_[i - 1]));
    }
    /// Largest change of the square of the speed along a block, mm²/s².
    static double reachOf(const Block& block) noexcept { return 2.0 * block.acceleration * block.length; }
    double exitOf(std::size_t i) const noexcept { return i + 1 < blocks_.size() ? blocks_[i + 1].entry : 0.0; }

    const ParsedProgram& program_;
    const MachineProfile& machine_;
    std::vector<Block> blocks_;
    std::vector<double> alone_; ///< s, by motion: of motions made from rest to rest
    bool atRest_ = true;
    MachiningTime time_;
};

} // namespace

std::vector<StatedPathMode> statedPathModes(const ParsedProgram& program) {
    std::vector<StatedPathMode> modes;
    for (const NcMotion& motion : program.motions) {
        const StatedPathMode mode{motion.line, motion.pathMode, motion.blendTolerance};
        const StatedPathMode last = modes.empty() ? StatedPathMode{0, PathMode::machine, 0.0} : modes.back();
        if (mode.mode != last.mode || mode.tolerance != last.tolerance) modes.push_back(mode);
    }
    return modes;
}

MachiningTime machiningTime(const ParsedProgram& program, const MachineProfile& machine) {
    return Planner(program, machine).plan();
}

} // namespace burin
