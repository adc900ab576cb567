// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/verify/limits.h"

#include <algorithm>

namespace burin {

namespace {

/// mm of way along an axis that a tip so far away would take.
double wayTo(const glm::dvec3& tip, int axis, const Box& travel) {
    return std::max(travel.high[axis], tip[axis]) - std::min(travel.low[axis], tip[axis]);
}

} // namespace

void judgeLimits(const std::vector<ToolMove>& moves, double spindleSpeed, const MachineProfile& machine,
                 const Box& travel, Findings& findings) {
    Box used;
    for (const ToolMove& move : moves) {
        if (!move.rapid && !move.startKnown) findings.add(FindingKind::unknownStart, move.line, move.to.tip, 0.0);
        if (!move.rapid && move.feed > machine.maximumFeed)
            findings.add(FindingKind::feedLimit, move.line, move.to.tip, move.feed);
        if (!move.endKnown) continue;
        used.include(move.to.tip);
        // Where nobody said how the setup stands on the table, only the way itself can be too long.
        for (int axis = 0; axis < 3; ++axis) {
            if (used.size()[axis] > machine.travel[axis])
                findings.add(FindingKind::travelLimit, move.line, move.to.tip, used.size()[axis]);
            if (!travel.empty() && (move.to.tip[axis] < travel.low[axis] || move.to.tip[axis] > travel.high[axis]))
                findings.add(FindingKind::travelLimit, move.line, move.to.tip, wayTo(move.to.tip, axis, travel));
        }
    }
    if (!moves.empty() && (spindleSpeed > machine.maximumSpindleSpeed ||
                           (spindleSpeed > 0.0 && spindleSpeed < machine.minimumSpindleSpeed)))
        findings.add(FindingKind::spindleLimit, moves.front().line, moves.front().to.tip, spindleSpeed);
}

} // namespace burin
