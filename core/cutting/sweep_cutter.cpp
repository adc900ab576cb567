// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/sweep_cutter.h"

#include "core/cutting/counted_removal.h"
#include "core/cutting/footprint.h"
#include "core/cutting/line_frame.h"

#include <utility>

namespace burin {

SweepCutter::SweepCutter(std::vector<RevolvedPiece> pieces, double edge)
    : pieces_(std::move(pieces)), reach_(reachOf(pieces_)), tolerance_(turnTolerance * edge) {}

void SweepCutter::cut(RunVolume& workpiece, const ToolPose& from, const ToolPose& to,
                      RemovedUnits& removed) const noexcept {
    RunAmounts taken;
    const PoseSteps steps(from, to, reach_, tolerance_);
    for (std::int32_t k = 0; k < steps.count(); ++k)
        if (!cutStep(workpiece, steps.step(k), taken, removed)) break;
    for (std::size_t property = 0; property < taken.units.size(); ++property)
        removed.byProperty[property] += taken.units[property];
}

/// Returns false if the workpiece's memory is used up.
bool SweepCutter::cutStep(RunVolume& workpiece, const PoseStep& step, RunAmounts& taken,
                          RemovedUnits& removed) const noexcept {
    const Grid& grid = workpiece.grid();
    const auto take = [&](LineIndex line, RunPosition from, RunPosition to) {
        return removeCounted(workpiece, line, from, to, taken, removed);
    };
    // Most of the range of a step was cut by the step before it.
    const auto wanted = [&workpiece](LineIndex line, RunPosition from, RunPosition to) {
        return machinableWithin(workpiece, line, from, to);
    };
    const glm::dvec3 fromTip = inLineFrame(grid, step.fromTip), toTip = inLineFrame(grid, step.toTip);
    for (const RevolvedPiece& piece : pieces_) {
        forEachSpan(SweptPiece(piece, fromTip, toTip, inLineFrame(grid, step.axis)), grid, take, wanted);
        if (removed.outOfMemory) return false;
    }
    return true;
}

} // namespace burin
