// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/verify/load_chart.h"

#include "core/base/units.h"
#include "core/cutting/cutting_force.h"

#include <algorithm>

namespace burin {

namespace {

/// What a motion removed, over all the straight moves that it was made of.
struct Taken {
    double volume = 0.0;
    glm::dvec3 moment{0.0};
    const ToolMove* last = nullptr;
};

std::vector<Taken> byMotion(std::size_t motions, const std::vector<ToolMove>& moves, const std::vector<MoveCut>& cuts) {
    std::vector<Taken> taken(motions);
    for (std::size_t i = 0; i < moves.size(); ++i) {
        Taken& motion = taken[moves[i].motion];
        motion.volume += cuts[i].volume;
        motion.moment += cuts[i].volume * cuts[i].centroid;
        motion.last = &moves[i];
    }
    return taken;
}

void addForce(const NcMotion& motion, const Tool& tool, const CuttingCoefficients::Entry& material, MotionLoad& load) {
    const double turns = motion.spindleOn() ? motion.spindleSpeed / secondsPerMinute : 0.0; // 1/s
    const double radius = tool.cutter.radius(), edgeSpeed = 2.0 * pi * radius * turns;
    if (!(edgeSpeed > 0.0) || !(load.removalRate > 0.0)) return;
    const double perTooth = motion.feed / secondsPerMinute / (turns * std::max(1, tool.fluteCount));
    const double energy = material.energyAt(2.0 * perTooth / pi);
    load.power = energy * load.removalRate;
    load.force = newtonMillimetresPerJoule * load.power / edgeSpeed;
}

} // namespace

std::vector<MotionLoad> loadChart(const ParsedProgram& program, const std::vector<ToolMove>& moves,
                                  const std::vector<MoveCut>& cuts, std::span<const Tool> tools,
                                  const MachiningTime& time, const PropertyList& properties, PropertyIndex material) {
    std::vector<CuttingCoefficients::Entry> coefficients; // by tool
    for (const Tool& tool : tools)
        coefficients.push_back(cuttingCoefficients(properties, tool.cutter.diameter).byProperty[material]);
    std::vector<MotionLoad> chart;
    const std::vector<Taken> taken = byMotion(program.motions.size(), moves, cuts);
    for (std::size_t i = 0; i < taken.size(); ++i) {
        if (!(taken[i].volume > 0.0)) continue;
        const NcMotion& motion = program.motions[i];
        MotionLoad load;
        load.motion = static_cast<std::uint32_t>(i);
        load.line = motion.line;
        load.start = time.motions[i].start;
        load.duration = time.motions[i].duration;
        load.volume = taken[i].volume;
        load.place = taken[i].moment / taken[i].volume;
        if (load.duration > 0.0) load.removalRate = load.volume / load.duration;
        addForce(motion, tools[taken[i].last->tool], coefficients[taken[i].last->tool], load);
        chart.push_back(load);
    }
    return chart;
}

const MotionLoad* peakLoad(const std::vector<MotionLoad>& chart) {
    const auto less = [](const MotionLoad& a, const MotionLoad& b) {
        return a.force != b.force ? a.force < b.force : a.removalRate < b.removalRate;
    };
    const auto peak = std::max_element(chart.begin(), chart.end(), less);
    return peak == chart.end() ? nullptr : &*peak;
}

} // namespace burin
