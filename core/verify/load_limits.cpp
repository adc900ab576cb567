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

/// A limit of 0 means none.
bool isWithin(double amount, double limit) {
    return !(limit > 0.0) || !(amount > limit * (1.0 + rounding));
}

/// The thickest chip of a turn, mm: a narrow cut has it where a tooth enters or leaves (chip thinning).
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
        const double edge = teeth * 0.5 * angle * slot / (2.0 * pi * radius); // mm, engaged on average
        const double force = ofChip + material.edgeForce * edge;
        const double side = std::hypot(force, material.radialRatio * ofChip + material.radialEdgeForce * edge);
        const double power = force * edgeSpeed / newtonMillimetresPerJoule;
        if (const double most = machine.powerAt(conditions.spindleSpeed); most > 0.0 && power > most) return false;
        if (tool.strength > 0.0 && beam.stressUnder(side, 0.5 * depth) > tool.strength / breakingReserve) return false;
        return beam.bendingUnder(side, 0.5 * depth) <= cut.bending;
    };
    // Deep cuts act closer to the holder: the load need not increase with depth throughout.
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

void LoadJudge::judge(const ToldLoad& told, const Asked& asked) {
    if (isWithin(asked.amount, asked.limit)) return;
    const Excess excess{{asked.kind, told.motion.line, told.load.place, asked.amount, asked.limit, 1},
                        tools_[told.tool].cutter.diameter,
                        asked.estimated};
    const auto [entry, isNew] = worst_.try_emplace({asked.kind, told.motion.line}, excess);
    if (!isNew && excess.share() > entry->second.share()) entry->second = excess;
}

std::array<LoadJudge::Asked, 4> LoadJudge::askedByFeed(const NcMotion& motion, std::size_t number,
                                                       const CutLoad& load) const {
    const Tool& tool = tools_[number];
    const bool turns = motion.spindleOn() && motion.spindleSpeed > 0.0;
    return {Asked{FindingKind::spindlePower, load.power, turns ? machine_->spindlePower : 0.0,
                  machine_->isEstimate("spindle_power_w")},
            Asked{FindingKind::spindleTorque, load.torque, turns ? machine_->torqueAt(motion.spindleSpeed) : 0.0,
                  machine_->isEstimate("spindle_torque")},
            Asked{FindingKind::toolBreakage, beams_[number].stressUnder(load.side, load.height),
                  tool.strength / breakingReserve, tool.isEstimate("strength_n_per_mm2")},
            Asked{FindingKind::chipLoad, thickestChip(load, tool.cutter.diameter), tool.maximumChipLoad,
                  tool.isEstimate("maximum_chip_load_mm")}};
}

bool LoadJudge::areWithin(const std::array<Asked, 4>& asked) {
    return std::ranges::all_of(asked, [](const Asked& one) { return isWithin(one.amount, one.limit); });
}

/// These loads decrease monotonically with the feed, so that bisection finds the greatest allowed feed.
void LoadJudge::limitFeed(const ToldLoad& told) {
    double borne = 0.0, tooFast = told.feed;
    for (int i = 0; i < 30; ++i) {
        const double middle = 0.5 * (borne + tooFast);
        (areWithin(askedByFeed(told.motion, told.tool, told.at(middle))) ? borne : tooFast) = middle;
    }
    const auto [entry, isNew] = feeds_.try_emplace(told.number, borne);
    if (!isNew) entry->second = std::min(entry->second, borne);
}

void LoadJudge::look(const ToldLoad& told) {
    const Tool& tool = tools_[told.tool];
    const CutLoad& load = told.load;
    const std::array<Asked, 4> byFeed = askedByFeed(told.motion, told.tool, load);
    for (const Asked& asked : byFeed) judge(told, asked);
    if (!areWithin(byFeed)) limitFeed(told);
    judge(told, {FindingKind::toolBending, beams_[told.tool].bendingUnder(load.side, load.height), bending_, true});
    judge(told,
          {FindingKind::depthOfCut, load.depth, tool.maximumDepthOfCut, tool.isEstimate("maximum_depth_of_cut_mm")});
    judge(told,
          {FindingKind::widthOfCut, load.width, tool.maximumWidthOfCut, tool.isEstimate("maximum_width_of_cut_mm")});
}

std::vector<FeedLimit> LoadJudge::feedLimits() const {
    std::vector<FeedLimit> limits;
    for (const auto& [motion, feed] : feeds_) limits.push_back({motion, feed});
    return limits;
}

/// Groups the findings of a kind that are near each other; the worst first.
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
