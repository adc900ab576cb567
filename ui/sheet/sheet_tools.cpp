// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/sheet/sheet_tools.h"

#include "core/verify/machine_time.h"

#include <algorithm>
#include <limits>

namespace burin {

namespace {

void include(double value, double& least, double& most) {
    if (!(value > 0.0)) return;
    least = least > 0.0 ? std::min(least, value) : value;
    most = std::max(most, value);
}

void add(const NcMotion& motion, double seconds, ToolUse& use) {
    use.seconds += seconds;
    include(motion.spindleSpeed, use.leastSpeed, use.mostSpeed);
    if (motion.rapid() || motion.kind == NcMotionKind::dwell) return;
    include(motion.feed, use.leastFeed, use.mostFeed);
    if (motion.endKnown()) use.deepest = std::min(use.deepest, motion.to[Axis::z]);
}

} // namespace

ProgramUse useOf(const ParsedProgram& program, const std::vector<Tool>& tools, const MachineProfile& machine) {
    const MachiningTime time = machiningTime(program, machine);
    ProgramUse use{time.seconds, std::vector<ToolUse>(tools.size())};
    for (std::size_t i = 0; i < program.motions.size(); ++i) {
        const auto same = [&](const Tool& tool) { return tool.number == program.motions[i].tool; };
        const auto tool = tools.size() == 1 ? tools.begin() : std::ranges::find_if(tools, same);
        if (tool == tools.end()) continue;
        add(program.motions[i], time.motions[i].duration, use.tools[static_cast<std::size_t>(tool - tools.begin())]);
    }
    return use;
}

} // namespace burin
