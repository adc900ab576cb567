// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/verify/tool_moves.h"

#include "core/machine/kinematics.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace burin {

namespace {

constexpr double sameTime = 1e-12; // min: axes whose arrivals differ by less arrive together

void appendRapid(const ToolMove& rapid, const MachineProfile& machine, std::vector<ToolMove>& moves) {
    if (!rapid.startKnown || !rapid.endKnown) {
        moves.push_back(rapid);
        return;
    }
    ToolMove interval = rapid;
    for (const glm::dvec3& corner : rapidWay(rapid.from.tip, rapid.to.tip, machine)) {
        interval.to.tip = corner;
        moves.push_back(interval);
        interval.from.tip = corner;
    }
}

/// The axes that have to be known at the ends of a move.
AxisSet axesToKnow(const ParsedProgram& program, const Kinematics& kinematics) {
    AxisSet named = linearAxes;
    for (const NcMotion& motion : program.motions) named = named | motion.toKnown;
    AxisSet axes;
    for (const Axis axis : kinematics.axes()) axes.set(axis, named.has(axis));
    return axes;
}

/// The number of parts of a move, so that the tool tilts little on each.
std::size_t partsOf(const NcMotion& motion, const Kinematics& kinematics, double largestTurn) {
    double most = 0.0;
    for (const Axis axis : kinematics.axes())
        if (isRotary(axis)) most = std::max(most, std::abs(motion.to[axis] - motion.from[axis]));
    const auto upright = [&](double share) {
        return isUpright(kinematics.poseOf(between(motion.from, motion.to, share)).axis);
    };
    if (!(most > 0.0) || (upright(0.0) && upright(0.5) && upright(1.0))) return 1;
    return static_cast<std::size_t>(std::clamp(std::ceil(most / largestTurn), 1.0, 1e5));
}

/// Appends a move whose axes turn, in parts.
void appendTurning(const ToolMove& move, const NcMotion& motion, const Kinematics& kinematics, double largestTurn,
                   std::vector<ToolMove>& moves) {
    const std::size_t parts = move.startKnown && move.endKnown ? partsOf(motion, kinematics, largestTurn) : 1;
    ToolMove part = move;
    for (std::size_t i = 1; i < parts; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(parts);
        part.to = kinematics.poseOf(between(motion.from, motion.to, share));
        moves.push_back(part);
        part.from = part.to;
    }
    part.to = move.to;
    moves.push_back(part);
}

} // namespace

std::vector<glm::dvec3> rapidWay(const glm::dvec3& from, const glm::dvec3& to, const MachineProfile& machine) {
    if (machine.rapids != RapidMode::independent) return {to};
    std::array<double, 3> arrival{}; // min
    for (int axis = 0; axis < 3; ++axis) {
        const double rate = machine.axisRate(axis);
        arrival[static_cast<std::size_t>(axis)] = rate > 0.0 ? std::abs(to[axis] - from[axis]) / rate : 0.0;
    }
    std::array<double, 3> times = arrival;
    std::sort(times.begin(), times.end());
    std::vector<glm::dvec3> corners;
    double last = 0.0;
    for (const double time : times) {
        if (time - last <= sameTime || times[2] - time <= sameTime) continue;
        glm::dvec3 corner = to;
        for (int axis = 0; axis < 3; ++axis) {
            const double whole = arrival[static_cast<std::size_t>(axis)];
            if (whole > time + sameTime) corner[axis] = from[axis] + (to[axis] - from[axis]) * (time / whole);
        }
        corners.push_back(corner);
        last = time;
    }
    corners.push_back(to);
    return corners;
}

std::vector<ToolMove> toolMoves(const ParsedProgram& program, const glm::dvec3& workOffset,
                                const MachineProfile& machine, std::span<const std::uint16_t> toolOf,
                                double largestTurn) {
    std::vector<ToolMove> moves;
    moves.reserve(program.motions.size());
    std::vector<NcMotion> straight;
    const std::unique_ptr<const Kinematics> kinematics = kinematicsOf(machine, workOffset);
    const AxisSet axes = axesToKnow(program, *kinematics);
    for (std::size_t i = 0; i < program.motions.size(); ++i) {
        straight.clear();
        appendStraightMoves(program.motions[i], arcChord, straight);
        for (const NcMotion& motion : straight) {
            ToolMove move;
            move.from = kinematics->poseOf(motion.from);
            move.to = kinematics->poseOf(motion.to);
            move.feed = motion.feed;
            move.line = motion.line;
            move.motion = static_cast<std::uint32_t>(i);
            move.tool = toolOf.empty() ? std::uint16_t{0} : toolOf[i];
            move.rapid = motion.rapid();
            move.spindleOn = motion.spindleOn();
            move.startKnown = motion.startKnown(axes);
            move.endKnown = motion.endKnown(axes);
            if (machine.tilts())
                appendTurning(move, motion, *kinematics, largestTurn, moves);
            else if (move.rapid)
                appendRapid(move, machine, moves);
            else
                moves.push_back(move);
        }
    }
    return moves;
}

} // namespace burin
