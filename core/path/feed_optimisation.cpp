// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/units.h"
#include "core/cutting/tool_beam.h"
#include "core/path/feed_intervals.h"
#include "core/path/spindle_schedule.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace burin {
namespace {

/// The target quantity as a function of the feed.
class Load {
public:
    /// @param fluteSpeed mm/s. @param spindleSpeed 1/min
    Load(const FeedOptimisation& edit, const PathContext& context, double fluteSpeed, double spindleSpeed,
         const PropertyList& materials)
        : force_(edit.goal != FeedOptimisation::Goal::removal)
        , coefficients_(cuttingCoefficients(materials, context.tool.cutter.diameter))
        , tool_(spinningTool(context.tool, fluteSpeed))
        , fluteSpeed_(fluteSpeed)
        , spindlePower_(context.machine.powerAt(spindleSpeed))
        , beam_(context.tool)
        , stress_(context.tool.strength / breakingReserve) {}

    /// N or mm³/s. @param feed mm/min, > 0
    double at(const MetInterval& met, double feed) const {
        if (!(met.length > 0.0) || !(met.reported > 0.0)) return 0.0;
        const double period = met.length / (feed / 60.0);
        return force_ ? forceIn(met, period) : met.reported / period;
    }

    /// The highest feed between both limits with a load up to `wanted` that spindle and tool bear; both loads rise with
    /// the feed.
    double feedFor(const MetInterval& met, double wanted, double low, double high) const {
        const auto allowed = [&](double feed) { return at(met, feed) <= wanted && isBorne(met, feed); };
        if (allowed(high)) return high;
        if (!allowed(low)) return low;
        for (int i = 0; i < 40; ++i) {
            const double middle = 0.5 * (low + high);
            (allowed(middle) ? low : high) = middle;
        }
        return low;
    }

private:
    double forceIn(const MetInterval& met, double period) const {
        return cuttingForce(met.cut(), coefficients_, tool_, ToolPose{met.from}, ToolPose{met.to}, period).tangential;
    }
    /// Whether spindle and tool bear the load.
    bool isBorne(const MetInterval& met, double feed) const {
        if (!(met.length > 0.0) || !(met.reported > 0.0)) return true;
        constexpr double millimetresPerMetre = 1000.0;
        const CuttingForce force = cuttingForce(met.cut(), coefficients_, tool_, ToolPose{met.from}, ToolPose{met.to},
                                                met.length / (feed / 60.0));
        if (spindlePower_ > 0.0 && force.tangential * fluteSpeed_ / millimetresPerMetre > spindlePower_) return false;
        if (!(stress_ > 0.0)) return true;
        const double side = std::hypot(force.tangential, force.radial);
        return beam_.stressUnder(side, std::max(0.0, met.centroid.z - met.to.z)) <= stress_;
    }

    bool force_;
    CuttingCoefficients coefficients_;
    SpinningTool tool_;
    double fluteSpeed_;   ///< mm/s
    double spindlePower_; ///< W; 0: not stated
    ToolBeam beam_;
    double stress_; ///< N/mm², limit of the tool's stress; 0: not stated
};

/// The limits at one spindle speed.
struct Turning {
    Load load;
    double low = 0.0, high = 0.0; ///< mm/min, allowed by chip load and machine
};

/// Computes and caches the limits for each spindle speed.
class Turnings {
public:
    Turnings(const FeedOptimisation& edit, const PathContext& context, const PropertyList& materials)
        : edit_(edit), context_(context), materials_(materials) {}

    /// @param speed 1/min
    const Turning& at(double speed) {
        const auto found = kept_.find(speed);
        return found != kept_.end() ? found->second : kept_.emplace(speed, make(speed)).first->second;
    }
    double lowest() const {
        double low = std::numeric_limits<double>::infinity();
        for (const auto& [speed, turning] : kept_) low = std::min(low, turning.low);
        return low;
    }

private:
    Turning make(double speed) const {
        const CuttingConditions& conditions = context_.conditions;
        const double teeth = speed * context_.tool.fluteCount; // per minute
        const double limit = context_.machine.maximumFeed > 0.0 ? context_.machine.maximumFeed : 1e9;
        const double thickest = context_.tool.maximumChipLoad > 0.0
                                    ? std::min(edit_.largestChip, context_.tool.maximumChipLoad)
                                    : edit_.largestChip;
        const double high = std::min(limit, teeth * std::max(edit_.smallestChip, thickest));
        return {Load(edit_, context_, conditions.surfaceSpeed * speed / conditions.spindleSpeed, speed, materials_),
                std::min(high, teeth * edit_.smallestChip), high};
    }

    const FeedOptimisation& edit_;
    const PathContext& context_;
    const PropertyList& materials_;
    std::map<double, Turning> kept_; ///< key: 1/min
};

/// Spindle speed per interval, as the path states it, 1/min, whatever the tables say.
std::vector<double> speedsOf(const std::vector<MetInterval>& record, const std::vector<PathPoint>& points,
                             double pathSpeed) {
    std::vector<SpindleInterval> intervals;
    std::vector<double> told;
    for (std::size_t i = 0; i < record.size(); ++i) {
        const PathPoint& move = points[record[i].move];
        told.push_back(speedOf(move, pathSpeed));
        intervals.push_back({told.back(), record[i].length / move.feed * secondsPerMinute,
                             i > 0 && record[i].from == record[i - 1].to});
    }
    return sureSpeeds(intervals, told, spindleStartTime);
}

/// Average over time of the path's cutting moves at their present feeds.
double meanLoad(const std::vector<MetInterval>& record, const std::vector<PathPoint>& points,
                const std::vector<double>& speeds, Turnings& turnings) {
    double sum = 0.0, time = 0.0;
    for (std::size_t i = 0; i < record.size(); ++i) {
        const MetInterval& met = record[i];
        const PathPoint& point = points[met.move];
        const double here = turnings.at(speeds[i]).load.at(met, point.feed);
        if (point.kind != MoveKind::cut || !(here > 0.0)) continue;
        sum += here * met.length / point.feed;
        time += met.length / point.feed;
    }
    return time > 0.0 ? sum / time : 0.0;
}

/// No interval is faster than the next one allows: v² = v'² + 2 a s.
void slowDownInTime(const std::vector<MetInterval>& record, double acceleration, std::vector<double>& feeds) {
    if (!(acceleration > 0.0)) return;
    for (std::size_t i = feeds.size() - 1; i-- > 0;) {
        if (record[i + 1].from != record[i].to) continue; // there is a rapid between them
        const double next = feeds[i + 1] / 60.0;
        feeds[i] = std::min(feeds[i], 60.0 * std::sqrt(next * next + 2.0 * acceleration * record[i].length));
    }
}

bool statesLimits(const PathContext& context) {
    return context.machine.spindlePower > 0.0 || !context.machine.spindleTorque.empty() ||
           context.tool.strength > 0.0 || context.tool.maximumChipLoad > 0.0;
}

} // namespace

Result<Deviation> apply(const FeedOptimisation& edit, PathUnderEdit& state, const PathContext& context,
                        Progress& progress) {
    const CuttingConditions& conditions = context.conditions;
    const bool limitsAlone = edit.goal == FeedOptimisation::Goal::limits;
    if (limitsAlone && (!context.lendStock || !statesLimits(context))) return Deviation{};
    if (!context.lendStock)
        return Error{ErrorCode::argumentInvalid, "stock", "", "feeds by engagement need the stock that is cut"};
    for (const PathPoint& point : state.points)
        if (point.kind != MoveKind::rapid && !(point.feed > 0.0))
            return Error{ErrorCode::argumentInvalid, "edits", "level-feed", "set-feed, then level-feed"};
    if (!(conditions.spindleSpeed > 0.0) || !(conditions.surfaceSpeed > 0.0))
        return Error{ErrorCode::argumentInvalid, "spindle speed", "", "above 0"};
    std::vector<MetInterval> record;
    PropertyList materials;
    const auto cutAgain = [&](RunVolume& stock) -> Result<void> {
        auto met = recordEngagement(state.points, context.tool, stock, edit.sampling, progress,
                                    limitsAlone ? RecordGrain::coarse : RecordGrain::fine);
        if (!met) return met.error();
        record = std::move(*met);
        materials = stock.properties();
        return {};
    };
    if (Result<void> cut = context.lendStock(cutAgain, progress); !cut) return cut.error();
    if (record.empty()) return Deviation{};
    const std::vector<double> speeds =
        speedsOf(record, state.points, state.spindleSpeed > 0.0 ? state.spindleSpeed : conditions.spindleSpeed);
    Turnings turnings(edit, context, materials);
    const double wanted = limitsAlone         ? std::numeric_limits<double>::infinity()
                          : edit.target > 0.0 ? edit.target
                                              : meanLoad(record, state.points, speeds, turnings);
    std::vector<double> feeds;
    for (std::size_t i = 0; i < record.size(); ++i) {
        const PathPoint& point = state.points[record[i].move];
        const Turning& turning = turnings.at(speeds[i]);
        const double most = limitsAlone ? std::min(point.feed, turning.high) : turning.high;
        feeds.push_back(point.kind == MoveKind::cut
                            ? turning.load.feedFor(record[i], wanted, std::min(turning.low, most), most)
                            : point.feed);
    }
    if (statesLimits(context)) state.leastFeed = turnings.lowest();
    if (limitsAlone) feeds = leastOfNeighbours(record, state.points, feeds);
    slowDownInTime(record, context.machine.acceleration, feeds);
    state.points = withFeeds(state.points, record, feeds, edit.leastChange);
    return Deviation{};
}

} // namespace burin
