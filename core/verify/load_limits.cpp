// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/verify/load_limits.h"

#include "core/base/units.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace burin {

namespace {

constexpr double nearbyAtLeast = 10.0; // mm
constexpr std::size_t mostOfAKind = 20;
constexpr double rounding = 1e-5; // of a limit that is just reached

/// mm: the thickest chip of a turn, which a narrow cut has where it is left or entered (chip thinning).
double thickestChip(const CutLoad& load, double diameter) {
    const double share = std::clamp(load.width / diameter, 0.0, 1.0);
    return share < 0.5 ? load.feedPerTooth * 2.0 * std::sqrt(share * (1.0 - share)) : load.feedPerTooth;
}

} // namespace

ForceLimit forceLimit(const Tool& tool, const MachineProfile& machine, double spindleSpeed) {
    ForceLimit limit;
    const auto include = [&](double force, FindingKind kind) {
        if (force > 0.0 && (limit.force == 0.0 || force < limit.force)) limit = {force, kind};
    };
    const double radius = tool.cutter.radius(), edgeSpeed = 2.0 * pi * radius * spindleSpeed / secondsPerMinute;
    include(tool.strength / breakingReserve / ToolBeam(tool).stressUnder(1.0, 0.0), FindingKind::toolBreakage);
    if (edgeSpeed > 0.0)
        include(newtonMillimetresPerJoule * machine.spindlePower / edgeSpeed, FindingKind::spindlePower);
    include(millimetresPerMetre * machine.torqueAt(spindleSpeed) / radius, FindingKind::spindleTorque);
    return limit;
}

double bearableDepth(const Tool& tool, const CuttingConditions& conditions, const CuttingCoefficients::Entry& material,
                     const MachineProfile& machine, const BearableCut& cut) {
    const ToolBeam beam(tool);
    const double radius = tool.cutter.radius(), teeth = tool.fluteCount;
    const double share = std::clamp(cut.width / (2.0 * radius), 1e-6, 1.0), angle = std::acos(1.0 - 2.0 * share);
    const double turns = conditions.spindleSpeed / secondsPerMinute, edgeSpeed = 2.0 * pi * radius * turns;
    const double speed = conditions.feed / secondsPerMinute;
    const double chip = speed / (turns * teeth) * 2.0 * share / angle; // mm, mean
    const auto isBorne = [&](double depth) {
        const double slot = slotArea(tool.cutter, depth);
        const double ofChip = newtonMillimetresPerJoule * material.energyAt(chip) * share * slot * speed / edgeSpeed;
        const double edge = teeth * 0.5 * angle * slot / (2.0 * pi * radius); // mm, engaged in the mean
        const double force = ofChip + material.edgeForce * edge;
        const double side = std::hypot(force, material.radialRatio * ofChip + material.radialEdgeForce * edge);
        const double power = force * edgeSpeed / newtonMillimetresPerJoule;
        if (const double most = machine.powerAt(conditions.spindleSpeed); most > 0.0 && power > most) return false;
        if (tool.strength > 0.0 && beam.stressUnder(side, 0.5 * depth) > tool.strength / breakingReserve) return false;
        return beam.bendingUnder(side, 0.5 * depth) <= cut.bending;
    };
    // Deep cuts attack nearer to the holder: what a depth asks for need not grow with it all the way.
    constexpr int steps = 256;
    const double flutes = tool.cutter.fluteLength;
    int within = 0;
    while (within < steps && isBorne(flutes * (within + 1) / steps)) ++within;
    if (within == steps) return flutes;
    double borne = flutes * within / steps, tooDeep = flutes * (within + 1) / steps;
    for (int i = 0; i < 20; ++i) {
        const double middle = 0.5 * (borne + tooDeep);
        (isBorne(middle) ? borne : tooDeep) = middle;
    }
    return borne;
}

LoadJudge::LoadJudge(const MachineProfile& machine, std::span<const Tool> tools, double bending)
    : machine_(&machine), tools_(tools), bending_(bending) {
    for (const Tool& tool : tools) beams_.emplace_back(tool);
}

void LoadJudge::judge(FindingKind kind, const NcMotion& motion, std::size_t tool, const CutLoad& load, double amount,
                      double limit, bool warns) {
    if (!(limit > 0.0) || !(amount > limit * (1.0 + rounding))) return;
    const Excess excess{{kind, motion.line, load.place, amount, limit, 1}, tools_[tool].cutter.diameter, warns};
    const auto [entry, isNew] = worst_.try_emplace({kind, motion.line}, excess);
    if (!isNew && excess.share() > entry->second.share()) entry->second = excess;
}

void LoadJudge::look(const NcMotion& motion, std::size_t number, const CutLoad& load) {
    const Tool& tool = tools_[number];
    const auto against = [&](FindingKind kind, double amount, double limit, bool warns) {
        judge(kind, motion, number, load, amount, limit, warns);
    };
    if (motion.spindleOn() && motion.spindleSpeed > 0.0) {
        against(FindingKind::spindlePower, load.power, machine_->spindlePower, machine_->isEstimate("spindle_power_w"));
        against(FindingKind::spindleTorque, load.torque, machine_->torqueAt(motion.spindleSpeed),
                machine_->isEstimate("spindle_torque"));
    }
    const ToolBeam& beam = beams_[number];
    against(FindingKind::toolBreakage, beam.stressUnder(load.side, load.height), tool.strength / breakingReserve,
            tool.isEstimate("strength_n_per_mm2"));
    against(FindingKind::toolBending, beam.bendingUnder(load.side, load.height), bending_, true);
    against(FindingKind::chipLoad, thickestChip(load, tool.cutter.diameter), tool.maximumChipLoad,
            tool.isEstimate("maximum_chip_load_mm"));
    against(FindingKind::depthOfCut, load.depth, tool.maximumDepthOfCut, tool.isEstimate("maximum_depth_of_cut_mm"));
    against(FindingKind::widthOfCut, load.width, tool.maximumWidthOfCut, tool.isEstimate("maximum_width_of_cut_mm"));
}

/// The worst first, each with those of its kind near by.
std::vector<LoadJudge::Excess> LoadJudge::gathered(std::vector<Excess> all) {
    std::ranges::stable_sort(all, std::greater{}, &Excess::share);
    std::vector<Excess> places;
    for (const Excess& excess : all) {
        std::size_t ofKind = 0;
        Excess* last = nullptr;
        const auto isAt = [&](Excess& place) {
            if (place.finding.kind != excess.finding.kind || place.warns != excess.warns) return false;
            ++ofKind;
            last = &place;
            return glm::distance(place.finding.place, excess.finding.place) <= std::max(nearbyAtLeast, place.diameter);
        };
        const auto at = std::ranges::find_if(places, isAt);
        if (at != places.end())
            ++at->finding.count;
        else if (ofKind < mostOfAKind)
            places.push_back(excess);
        else
            ++last->finding.count;
    }
    return places;
}

void LoadJudge::conclude(Findings& findings, std::vector<Finding>& warnings) const {
    std::vector<Excess> all;
    for (const auto& [key, excess] : worst_) all.push_back(excess);
    for (const Excess& excess : gathered(std::move(all))) {
        if (excess.warns)
            warnings.push_back(excess.finding);
        else
            findings.add(excess.finding);
    }
}

} // namespace burin
