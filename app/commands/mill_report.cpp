// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/commands/mill_report.h"

#include "app/surroundings.h"
#include "app/wording.h"
#include "core/base/numbers.h"
#include "core/base/units.h"

namespace burin {

namespace {

using nlohmann::json;

const char* nameOf(FeedBound bound) {
    switch (bound) {
    case FeedBound::chip:
        return "chip";
    case FeedBound::plunge:
        return "plunge";
    case FeedBound::thinned:
        return "thin-chip";
    case FeedBound::load:
        return "load";
    case FeedBound::limit:
        break;
    }
    return "limit";
}

/// The most demanding cut of a take, and the feed for it; null if nothing was cut, or the tables lack values.
json heaviestCutOf(const TakeOutcome& outcome, const PropertyList& properties) {
    if (!outcome.heaviestFeed) return nullptr;
    const SmoothedCut& cut = outcome.heaviestCut;
    const FeedProposal& feed = *outcome.heaviestFeed;
    return {{"area_mm2", cut.area},         {"engagement_rad", cut.arc},
            {"depth_mm", cut.depth},        {"material", properties[feed.material].id},
            {"feed_mm_per_min", feed.feed}, {"spindle_speed_rpm", feed.spindleSpeed},
            {"bound", nameOf(feed.bound)}};
}

/// Objects other than the part that held the tool, and motion that could not follow the hand.
std::string alarmsOf(const TakeOutcome& outcome, const ToolBounds& bounds) {
    std::string text;
    const auto add = [&text](std::uint64_t ticks, TextId what, const std::string& holder = {}) {
        if (ticks > 0) text += worded(what, {std::to_string(ticks), holder});
    };
    add(outcome.shankTicks, BURIN_TEXT("Command", "; shank or holder touched in %1 ticks"));
    for (std::size_t i = 1; i < bounds.layers().size(); ++i)
        add(outcome.layerTicks[i], BURIN_TEXT("Command", "; %2 held the tool in %1 ticks"), textOf(bounds.layers()[i]));
    add(outcome.stockTicks, BURIN_TEXT("Command", "; shank or holder were kept away from the stock in %1 ticks"));
    add(outcome.axisHeldTicks, BURIN_TEXT("Command", "; the axis was held in %1 ticks"));
    return text;
}

std::string heaviestText(const TakeOutcome& outcome, const PropertyList& properties) {
    if (!outcome.heaviestFeed) return {};
    const SmoothedCut& cut = outcome.heaviestCut;
    const FeedProposal& feed = *outcome.heaviestFeed;
    return worded(BURIN_TEXT("Command",
                             "; heaviest cut: %1 mm^2 of %2, engagement %3 degrees, depth %4 mm; feed for it: "
                             "%5 mm/min at %6 rpm"),
                  {formatFixed(cut.area, 2), properties[feed.material].id, formatFixed(cut.arc * 180.0 / pi, 0),
                   formatFixed(cut.depth, 2), formatFixed(feed.feed, 0), formatFixed(feed.spindleSpeed, 0)});
}

} // namespace

json jsonOf(const TakeOutcome& outcome, const ToolBounds& bounds, const PropertyList& properties) {
    json layers = jsonOf(bounds.layers());
    for (std::size_t i = 0; i < layers.size(); ++i) layers[i]["ticks_held"] = outcome.layerTicks[i];
    return {{"take", outcome.take},
            {"layers", layers},
            {"obstacle_ticks", outcome.obstacleTicks},
            {"axis_held_ticks", outcome.axisHeldTicks},
            {"stock_distance_ticks", outcome.stockTicks},
            {"samples", outcome.samples},
            {"ticks", outcome.loop.ticks},
            {"rate_hz", outcome.loop.rateHz},
            {"tick_us_p50", outcome.loop.workP50},
            {"tick_us_p999", outcome.loop.workP999},
            {"tick_cpu_us_p50", outcome.loop.cpuP50},
            {"tick_cpu_us_p999", outcome.loop.cpuP999},
            {"missed", outcome.loop.missed},
            {"interval_us_p50", outcome.loop.intervalP50},
            {"interval_us_p999", outcome.loop.intervalP999},
            {"late", outcome.loop.late},
            {"motor_cuts", outcome.loop.cuts},
            {"scheduling", nameOf(outcome.loop.scheduling)},
            {"memory_locked", outcome.loop.memoryLocked},
            {"duration_s", outcome.loop.simulatedSeconds},
            {"removed_mm3", outcome.removed},
            {"workpiece_drop_mm3", outcome.drop},
            {"shank_contact_ticks", outcome.shankTicks},
            {"force_max_n", outcome.largestForce},
            {"torque_max_n_mm", outcome.largestTorque},
            {"cutting_force_max_n", outcome.largestCuttingForce},
            {"heaviest_cut", heaviestCutOf(outcome, properties)}};
}
std::string textOf(const TakeOutcome& outcome, const ToolBounds& bounds, const PropertyList& properties) {
    return worded(BURIN_TEXT("Command", "take %1: %2 samples, %3 s, removed %4 mm^3; tick %5 us (p50), %6 us (p99.9), "
                                        "%7 Hz"),
                  {std::to_string(outcome.take), std::to_string(outcome.samples),
                   formatFixed(outcome.loop.simulatedSeconds, 1), formatFixed(outcome.removed, 1),
                   formatFixed(outcome.loop.workP50, 1), formatFixed(outcome.loop.workP999, 1),
                   formatFixed(outcome.loop.rateHz, 0)}) +
           heaviestText(outcome, properties) + alarmsOf(outcome, bounds);
}

} // namespace burin
