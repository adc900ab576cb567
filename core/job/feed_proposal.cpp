// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/feed_proposal.h"

#include "core/base/units.h"
#include "core/cutting/cutting_force.h"
#include "core/cutting/slot_chip.h"
#include "core/verify/load_limits.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

constexpr double mostOfTable = 2.0;    // a thin chip is compensated by at most this factor
constexpr double plungeArc = pi + 0.5; // rad: that of a slot plus the error of Engagement::arc

/// The cut in one of its materials, for any feed.
class CutInMaterial {
public:
    CutInMaterial(const SmoothedCut& cut, const Tool& tool, const CuttingConditions& conditions, PropertyIndex material,
                  const CuttingCoefficients& coefficients)
        : coefficients_(coefficients), tool_(spinningTool(tool, conditions.surfaceSpeed)) {
        cut_.removed[0] = {material, 0, 0.0, cut.area * length};
        cut_.reported = cut.area * length;
        cut_.engagement = {cut.arc, cut.depth, cut.surface};
    }
    /// Returns the mean tangential force over a revolution, N. @param feed mm/min, > 0
    double force(double feed) const noexcept {
        const ToolPose from{{0.0, 0.0, 0.0}}, to{{length, 0.0, 0.0}};
        return cuttingForce(cut_, coefficients_, tool_, from, to, length / (feed / secondsPerMinute)).tangential;
    }

private:
    static constexpr double length = 1.0; // mm, of tool motion
    CutResult cut_;
    const CuttingCoefficients& coefficients_;
    SpinningTool tool_;
};

/// Returns the largest feed in [0, feed] at which the force stays below the limit; the force increases with the feed.
double bearableFeed(const CutInMaterial& cut, double feed, double limit) {
    if (!(limit > 0.0) || cut.force(feed) <= limit) return feed;
    double low = 0.0, high = feed;
    for (int i = 0; i < 40; ++i) {
        const double middle = 0.5 * (low + high);
        (cut.force(middle) <= limit ? low : high) = middle;
    }
    return low;
}

FeedProposal feedIn(PropertyIndex material, const SmoothedCut& cut, const Tool& tool, const MachineProfile& machine,
                    const CuttingConditions& conditions, const CuttingCoefficients& coefficients) {
    FeedProposal proposal{conditions.feed, conditions.spindleSpeed, material, FeedBound::chip};
    const auto atMost = [&proposal](double feed, FeedBound bound) {
        if (!(feed < proposal.feed)) return;
        proposal.feed = feed;
        proposal.bound = bound;
    };
    if (cut.arc > plungeArc) {
        proposal.feed = conditions.plungeFeed;
        proposal.bound = FeedBound::plunge;
    } else if (cut.surface > 0.0) {
        const double ratio = std::min(1.0, cut.area / cut.surface);
        proposal.feed *= std::max(1.0, slotChipRatio / ratio);
        atMost(mostOfTable * conditions.feed, FeedBound::thinned);
    }
    if (machine.maximumFeed > 0.0) atMost(machine.maximumFeed, FeedBound::limit);
    if (tool.maximumChipLoad > 0.0)
        atMost(conditions.spindleSpeed * tool.fluteCount * tool.maximumChipLoad, FeedBound::limit);
    const double borne = forceLimit(tool, machine, conditions.spindleSpeed).force;
    atMost(bearableFeed(CutInMaterial(cut, tool, conditions, material, coefficients), proposal.feed, borne),
           FeedBound::load);
    return proposal;
}

} // namespace

std::optional<FeedProposal> proposeFeed(const SmoothedCut& cut, const Tool& tool, const MachineProfile& machine,
                                        const PropertyList& properties) {
    if (!cut.cuts() || !tool.cutter.turns()) return std::nullopt;
    // The spindle has one speed for all materials, and the chips depend on it.
    double spindleSpeed = machine.maximumSpindleSpeed;
    for (const PropertyIndex material : cut.materials) {
        if (material == airProperty) break;
        const auto conditions = cuttingConditions(tool, properties[material], spindleSpeed, machine.maximumFeed);
        if (!conditions) return std::nullopt;
        spindleSpeed = conditions->spindleSpeed;
    }
    const CuttingCoefficients coefficients = cuttingCoefficients(properties, tool.cutter.diameter);
    std::optional<FeedProposal> least;
    for (const PropertyIndex material : cut.materials) {
        if (material == airProperty) break;
        const auto conditions = cuttingConditions(tool, properties[material], spindleSpeed, machine.maximumFeed);
        if (!conditions) return std::nullopt;
        const FeedProposal proposal = feedIn(material, cut, tool, machine, *conditions, coefficients);
        if (!least || proposal.feed < least->feed) least = proposal;
    }
    return least;
}

} // namespace burin
