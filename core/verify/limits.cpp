// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/verify/limits.h"

#include "core/machine/axis_travel.h"
#include "core/machine/kinematics.h"

namespace burin {

namespace {

constexpr double angleRounding = 1e-4; // degrees, of a program's numbers

} // namespace

Result<void> judgeLimits(const std::vector<ToolMove>& moves, double spindleSpeed, const MachineProfile& machine,
                         const Box& travel, Findings& findings) {
    const std::unique_ptr<const Kinematics> kinematics = kinematicsOf(machine, glm::dvec3(0.0));
    // if the position of the setup is not known, only the length of the motion can be too large
    AxisTravel axes(machine, travel);
    for (const ToolMove& move : moves) {
        if (!move.rapid && !move.startKnown) findings.add(FindingKind::unknownStart, move.line, move.to.tip, 0.0);
        if (!move.rapid && move.feed > machine.maximumFeed)
            findings.add(FindingKind::feedLimit, move.line, move.to.tip, move.feed);
        if (!move.endKnown) continue;
        const Result<AxisValues> values = kinematics->axesOf({move.to.tip}); // rotary axes: judgeRotaryAxes
        if (!values) return values.error();
        axes.goTo(linearAxes, *values);
        for (const Axis axis : linearAxes)
            if (const std::optional<double> way = axes.wayBeyond(axis))
                findings.add(FindingKind::travelLimit, move.line, move.to.tip, *way);
    }
    if (!moves.empty() && (spindleSpeed > machine.maximumSpindleSpeed ||
                           (spindleSpeed > 0.0 && spindleSpeed < machine.minimumSpindleSpeed)))
        findings.add(FindingKind::spindleLimit, moves.front().line, moves.front().to.tip, spindleSpeed);
    return {};
}

void judgeRotaryAxes(const ParsedProgram& program, const MachineProfile& machine, Findings& findings) {
    const std::unique_ptr<const Kinematics> kinematics = kinematicsOf(machine, glm::dvec3(0.0));
    for (const NcMotion& motion : program.motions)
        for (const RotaryAxis& rotary : machine.rotaryAxes) {
            if (!motion.takes(rotary.axis)) continue;
            const double value = motion.to[rotary.axis];
            if (value < rotary.low - angleRounding || value > rotary.high + angleRounding)
                findings.add(FindingKind::rotaryLimit, motion.line, kinematics->poseOf(motion.to).tip, value);
        }
}

} // namespace burin
