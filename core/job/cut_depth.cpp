// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/cut_depth.h"

#include "core/passes/pass_request.h"
#include "core/verify/load_limits.h"

#include <algorithm>

namespace burin {

namespace {

/// Returns the usual depth of cut in a material, as a share of the tool diameter, for rows nearly as wide as the tool,
/// derived from the specific cutting energy. Workshop rules: a full diameter and more in wax and board, half a diameter
/// in aluminium, a quarter in steel. Estimates; a tool's own limit applies as well.
double depthShare(const Property& material) {
    constexpr double soft = 0.2, light = 1.5; // J/mm³
    const double energy = material.valueOr(specificCuttingEnergy, light);
    return energy <= soft ? 2.0 : energy <= light ? 0.5 : 0.25;
}

/// Returns the allowed deflection of a tool while stock is left on the part, mm: long tools that bend by more than a
/// hundredth of their diameter are audible in the shop. Our estimate.
double roughingBending(const Tool& tool) {
    constexpr double share = 0.01, least = 0.02;
    return std::max(least, share * tool.cutter.diameter);
}

} // namespace

double deepestCut(const MillingContext& milling, double width) {
    const PropertyIndex stock = milling.embedded.stockProperty;
    const CuttingCoefficients::Entry law =
        cuttingCoefficients(milling.embedded.workpiece.properties(), milling.tool.cutter.diameter).byProperty[stock];
    const double borne =
        bearableDepth(milling.tool, milling.conditions, law, milling.machine, {width, roughingBending(milling.tool)});
    return milling.tool.maximumDepthOfCut > 0.0 ? std::min(borne, milling.tool.maximumDepthOfCut) : borne;
}

Tool plannedTool(const MillingContext& milling) {
    Tool tool = milling.tool;
    const double share = depthShare(milling.embedded.workpiece.properties()[milling.embedded.stockProperty]);
    tool.maximumDepthOfCut = std::min(share * tool.cutter.diameter, deepestCut(milling, tool.cutter.diameter));
    return tool;
}

ClearingSteps clearingSteps(const MillingContext& milling) {
    ClearingSteps steps{usualRoughStep * milling.tool.cutter.diameter, plannedTool(milling).maximumDepthOfCut};
    const Property& stock = milling.embedded.workpiece.properties()[milling.embedded.stockProperty];
    const CuttingPreset* preset = presetFor(milling.tool, stock);
    if (preset == nullptr) return steps;
    if (preset->stepOver > 0.0) steps.stepOver = preset->stepOver;
    if (preset->stepDown > 0.0) steps.levelDepth = std::min(steps.levelDepth, preset->stepDown);
    return steps;
}

StandingStock seenFromAbove(const RunVolume& workpiece) {
    const Grid& grid = workpiece.grid();
    if (grid.axis() != RunAxis::z) return {};
    StandingStock standing{glm::dvec2(grid.low()), grid.edge(), grid.lineCountU(), grid.lineCountV(), {}, {}};
    for (std::int32_t v = 0; v < grid.lineCountV(); ++v)
        for (std::int32_t u = 0; u < grid.lineCountU(); ++u) {
            double highest = WorkpieceHeights::nothing, thickness = 0.0, from = grid.low().z;
            for (const Segment& segment : workpiece.line({u, v})) {
                const double to = grid.toMillimetres(segment.end());
                const PropertyIndex property = segment.property();
                if (property != airProperty &&
                    workpiece.properties()[property].machinability == Machinability::machinable) {
                    thickness = to - from;
                    highest = to;
                }
                from = to;
            }
            standing.heights.push_back(highest);
            standing.thickness.push_back(thickness);
        }
    return standing;
}

} // namespace burin
