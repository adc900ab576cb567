// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/material_feed.h"

#include "core/base/units.h"
#include "core/path/feed_intervals.h"
#include "core/path/spindle_schedule.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin {
namespace {

constexpr double sampling = 0.5;     // mm, as FeedOptimisation's
constexpr double leastChange = 0.02; // relative
constexpr double crumb = 1e-3;       // share of the removed volume: rounding at a border

/// Calls `use` for each material that an interval mills, except for traces caused by rounding.
template <class Use>
void forEachMaterial(const MetInterval& met, const Use& use) {
    double all = 0.0;
    for (const MaterialVolume& material : met.removed) all += material.volume;
    for (const MaterialVolume& material : met.removed)
        if (material.volume > crumb * all) use(material.property);
}

/// The ratio of an interval's feeds to those of the one material, for cuts and plunges; a lower spindle speed keeps the
/// chip load.
class Shares {
public:
    Shares(const std::vector<CuttingConditions>& conditions, const CuttingConditions& one)
        : conditions_(conditions), one_(one) {}

    /// Highest speed that the materials of an interval allow, 1/min; infinite if there are none.
    double fastest(const MetInterval& met) const {
        double least = std::numeric_limits<double>::infinity();
        forEachMaterial(met, [&](PropertyIndex material) {
            if (conditions_[material].spindleSpeed > 0.0) least = std::min(least, conditions_[material].spindleSpeed);
        });
        return least;
    }

    /// The ratio at a spindle speed, 1/min. Infinite if the interval meets no material.
    double of(const MetInterval& met, MoveKind kind, double spindleSpeed) const {
        double least = std::numeric_limits<double>::infinity();
        forEachMaterial(met, [&](PropertyIndex material) {
            const CuttingConditions& here = conditions_[material];
            if (!(here.spindleSpeed > 0.0)) return;
            const double turns = spindleSpeed / here.spindleSpeed;
            least = std::min(least, kind == MoveKind::plunge ? turns * here.plungeFeed / one_.plungeFeed
                                                             : turns * here.feed / one_.feed);
        });
        return least;
    }

private:
    const std::vector<CuttingConditions>& conditions_;
    const CuttingConditions& one_;
};

/// The lowest of the speeds that the materials on the path allow, everywhere; infinite if there are none.
SpindleSpeeds oneSpeed(const std::vector<MetInterval>& record, const Shares& shares) {
    double least = std::numeric_limits<double>::infinity();
    for (const MetInterval& met : record) least = std::min(least, shares.fastest(met));
    return {{}, std::vector<double>(record.size(), least)};
}

SpindleSpeeds speedsByMaterial(const std::vector<MetInterval>& record, const std::vector<PathPoint>& points,
                               const Shares& shares) {
    std::vector<SpindleInterval> intervals;
    for (std::size_t i = 0; i < record.size(); ++i) {
        const PathPoint& move = points[record[i].move];
        const double fastest = shares.fastest(record[i]);
        const double share = std::isinf(fastest) ? 1.0 : shares.of(record[i], move.kind, fastest);
        intervals.push_back({fastest, record[i].length / (share * move.feed) * secondsPerMinute,
                             i > 0 && record[i].from == record[i - 1].to});
    }
    return spindleSchedule(intervals, spindleStartTime);
}

/// Intervals in air take the value of the next interval in material, at the end that of the last one.
void fillAir(std::vector<double>& shares) {
    const auto isMet = [](double share) { return share < std::numeric_limits<double>::infinity(); };
    double next = 0.0;
    for (std::size_t i = shares.size(); i-- > 0;) {
        if (isMet(shares[i]))
            next = shares[i];
        else if (next > 0.0)
            shares[i] = next;
    }
    const auto last = std::find_if(shares.rbegin(), shares.rend(), isMet);
    const double share = last == shares.rend() ? 1.0 : *last;
    for (double& each : shares)
        if (!isMet(each)) each = share;
}

} // namespace

Result<void> feedByMaterial(PathUnderEdit& state, const PathContext& context,
                            const std::vector<CuttingConditions>& conditions, const CuttingConditions& feeds,
                            SetFeed::Spindle spindle, Progress& progress) {
    std::vector<MetInterval> record;
    const auto cutAgain = [&](RunVolume& stock) -> Result<void> {
        auto met = recordEngagement(state.points, context.tool, stock, sampling, progress, RecordGrain::coarse);
        if (!met) return met.error();
        record = std::move(*met);
        return {};
    };
    if (Result<void> cut = context.lendStock(cutAgain, progress); !cut) return cut;
    const Shares shares(conditions, feeds);
    const SpindleSpeeds speeds =
        spindle == SetFeed::Spindle::one ? oneSpeed(record, shares) : speedsByMaterial(record, state.points, shares);
    const double first = speeds.sureOf.empty() ? std::numeric_limits<double>::infinity() : speeds.sureOf.front();
    if (std::isinf(first)) return {}; // it meets no material
    std::vector<double> share;
    for (std::size_t i = 0; i < record.size(); ++i)
        share.push_back(shares.of(record[i], state.points[record[i].move].kind, speeds.sureOf[i]));
    fillAir(share);
    const double most = context.machine.maximumFeed > 0.0 ? context.machine.maximumFeed : feeds.feed;
    std::vector<double> asked;
    for (std::size_t i = 0; i < record.size(); ++i)
        asked.push_back(std::min(most, share[i] * state.points[record[i].move].feed));
    state.points =
        withFeeds(state.points, record, leastOfNeighbours(record, state.points, asked), leastChange, speeds.told);
    state.spindleSpeed = first; // the speed of the first cut
    return {};
}

} // namespace burin
