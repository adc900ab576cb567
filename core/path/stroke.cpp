// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/stroke.h"

#include "core/base/parallel.h"
#include "core/geometry/upright.h"
#include "core/path/apply.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

/// A few ticks lost by the recorder don't split a stroke.
constexpr std::uint64_t longestGap = 5; // ticks
/// A tip faster than any hand was moved by something else (another mapping); the move between is not part of the work.
constexpr double fastestHand = 2000.0; // mm/s, estimate; over the elapsed time, including missed ticks
/// Shank or holder touched something, or the spindle stood still.
constexpr std::uint32_t notWork = sampleShankContact | sampleSpindleOff;

bool removes(const Sample& sample) noexcept {
    return std::ranges::any_of(sample.removed, [](const RemovedMaterial& m) { return m.property != 0 && m.units > 0; });
}

/// The longest delay of the loop across which a stroke continues, 0.1 s at 1 kHz; a longer one counts as this.
constexpr std::int64_t mostFilled = 100; // points

/// The tool went straight from the last point to this one: the flags of the end apply to all points of the move.
void fillUp(std::vector<StrokePoint>& points, const StrokePoint& to, std::int64_t missing) {
    const StrokePoint from = points.back();
    for (std::int64_t i = 1; i <= missing; ++i) {
        StrokePoint between = to;
        between.pose.tip =
            glm::mix(from.pose.tip, to.pose.tip, static_cast<double>(i) / static_cast<double>(missing + 1));
        between.sample = from.sample;
        between.onBoundary = from.onBoundary && to.onBoundary;
        points.push_back(between);
    }
}

/// A take in memory may not state it.
double periodOf(const TakeInfo& info) noexcept {
    return info.tickPeriod > 0.0 ? info.tickPeriod : TakeInfo{}.tickPeriod;
}

} // namespace

bool touches(const SourceInterval& interval, const PathStroke& stroke) noexcept {
    return std::ranges::any_of(stroke.points, [&](const StrokePoint& p) { return contains(interval, stroke, p); });
}

bool holds(const PathStroke& stroke, const Moment& moment) noexcept {
    if (moment.source == 0 || moment.source != stroke.source || stroke.points.empty()) return false;
    const auto [first, last] = std::ranges::minmax(stroke.points, {}, &StrokePoint::sample);
    return first.sample <= moment.tick && moment.tick <= last.sample;
}

PathStroke reversed(const PathStroke& stroke) {
    PathStroke back = stroke;
    std::ranges::reverse(back.points);
    for (std::size_t i = back.points.size(); i-- > 1;) { // properties of a motion stay with it
        back.points[i].arc = back.points[i - 1].arc;
        back.points[i].removes = back.points[i - 1].removes;
        back.points[i].onBoundary = back.points[i - 1].onBoundary;
        if (back.points[i].arc) back.points[i].arc->clockwise = !back.points[i].arc->clockwise;
    }
    if (!back.points.empty()) back.points.front().arc.reset();
    return back;
}

std::size_t PathUnderEdit::count() const noexcept {
    if (linked) return points.size();
    std::size_t sum = 0;
    for (const PathStroke& stroke : strokes) sum += stroke.points.size();
    return sum;
}

void StrokeReader::EvenTicks::begin(const Sample& sample) noexcept {
    tick_ = sample.tick;
    time_ = sample.time;
    last_ = 0;
}

std::int64_t StrokeReader::EvenTicks::missingBefore(const Sample& sample) noexcept {
    constexpr double farthest = 1e12; // periods; a damaged clock may report anything
    const double ticks = static_cast<double>(sample.tick - tick_), periods = (sample.time - time_) / period_;
    const auto place = static_cast<std::int64_t>(std::round(std::min(std::max(ticks, periods), farthest)));
    const std::int64_t missing = std::clamp<std::int64_t>(place - last_ - 1, 0, mostFilled);
    last_ = std::max(last_ + 1, place);
    return missing;
}

StrokeReader::StrokeReader(const TakeOutline& take)
    : made_{sourceOf(take.info), {}}, ranges_(take.undone), undone_(ranges_), ticks_(periodOf(take.info)) {
    made_.info.tickPeriod = periodOf(take.info);
}

Result<void> StrokeReader::add(std::span<const Sample> next) {
    for (const Sample& sample : next) {
        if (undone_.holds(index_++) || (sample.flags & notWork) != 0 || !isFinite(sample.proxy.tip)) {
            begins_ = true;
            continue;
        }
        if (!isUpright(sample.proxy.axis))
            return Error{ErrorCode::notSupported, "tilted tool axis",
                         "takes milled with the axis fixed at +Z (--axis fixed), unlike take " +
                             std::to_string(made_.info.source.id),
                         "sample " + std::to_string(sample.tick)};
        add(sample);
    }
    return {};
}

void StrokeReader::add(const Sample& sample) {
    const SourceInfo& info = made_.info;
    std::vector<PathStroke>& strokes = made_.strokes;
    const double elapsed =
        std::max(info.tickPeriod * static_cast<double>(sample.tick - lastTick_), sample.time - lastTime_);
    if (begins_ || sample.tick > lastTick_ + longestGap ||
        glm::distance(sample.proxy.tip, strokes.back().points.back().pose.tip) > fastestHand * elapsed) {
        if (!strokes.empty()) strokes.back().points.shrink_to_fit();
        strokes.push_back({info.source.id, info.allowance, info.allowance, info.tickPeriod, {}});
        ticks_.begin(sample);
    }
    std::vector<StrokePoint>& points = strokes.back().points;
    const StrokePoint point{{sample.proxy.tip, uprightAxis},
                            static_cast<std::int64_t>(sample.tick),
                            removes(sample),
                            (sample.flags & sampleOnBoundary) != 0};
    if (!points.empty()) fillUp(points, point, ticks_.missingBefore(sample));
    points.push_back(point);
    begins_ = false;
    lastTick_ = sample.tick;
    lastTime_ = sample.time;
}

SourceStrokes StrokeReader::finish() {
    if (!made_.strokes.empty()) made_.strokes.back().points.shrink_to_fit();
    return std::move(made_);
}

Result<SourceStrokes> recordedStrokes(const Take& take) {
    StrokeReader reader({take.info, take.undone});
    if (Result<void> read = reader.add(take.samples); !read) return std::move(read).error();
    return reader.finish();
}

Result<SourceStrokes> strokesOf(const GeneratedMoves& moves) {
    SourceStrokes made{sourceOf(moves.info), {}};
    for (const std::vector<GeneratedPoint>& stroke : moves.strokes) {
        PathStroke& last = made.strokes.emplace_back(
            PathStroke{moves.info.id, moves.info.allowance, moves.info.allowance, made.info.tickPeriod, {}});
        last.points.reserve(stroke.size());
        for (const GeneratedPoint& point : stroke) {
            last.points.push_back({{point.pose.tip, isUpright(point.pose.axis) ? uprightAxis : point.pose.axis},
                                   point.moment,
                                   point.removes,
                                   point.onBoundary,
                                   std::nullopt});
            if (point.feed > 0.0) made.stated.push_back({point.moment, point.feed, point.spindleSpeed, point.coolant});
        }
    }
    std::ranges::sort(made.stated, {}, &StatedFeed::moment);
    return made;
}

std::vector<PathPoint> pointsOf(const PathUnderEdit& state) {
    if (state.linked) return state.points;
    std::vector<PathPoint> points;
    points.reserve(state.count());
    for (const PathStroke& stroke : state.strokes) {
        MoveKind kind = MoveKind::rapid;
        for (const StrokePoint& point : stroke.points) {
            points.push_back({point.pose, kind, 0.0, stroke.source, point.sample, point.arc});
            kind = MoveKind::cut;
        }
    }
    return points;
}

Deviation changeEach(PathUnderEdit& state, const Progress& progress,
                     const std::function<Deviation(PathStroke&)>& change) {
    std::vector<Deviation> deviations(state.strokes.size());
    parallelFor(std::size_t{0}, state.strokes.size(), [&](std::size_t i) {
        if (!progress.cancelled()) deviations[i] = change(state.strokes[i]);
    });
    Deviation farthest;
    for (const Deviation& one : deviations) farthest.include(one);
    return farthest;
}

} // namespace burin
