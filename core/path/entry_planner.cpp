// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/entry_planner.h"

#include "core/base/units.h"
#include "core/geometry/arc.h"
#include "core/path/lead.h"
#include "core/path/stroke_access.h"
#include "core/path/stroke_steps.h"
#include "core/path/turn_room.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace burin {
namespace {

/// Depth of material that a tool may meet straight from above: left by tremor and by the voxels, mm.
constexpr double leastDepth = 0.15;
/// Share of the radius: material that reaches no farther in (at most 5 % of the tool's section) is a wall that the
/// flutes skim on their way down. More than half of that is added by the squares of the height map to every wall that
/// was cut.
constexpr double skimmedRim = 0.2;
constexpr double usualAngle = 3.0 * pi / 180.0; // if neither edit nor material states one
constexpr double longestLeg = 30.0;             // mm of a ramp
constexpr int mostTurns = 8;                    // of a ramp
constexpr double helixShare = 0.4;              // share of the diameter: radius of a helix, which leaves no core
/// Distance between the material and the start of a ramp or helix, mm.
constexpr double gap = 0.05;

/// Whether a stroke's beginning is level enough for a ramp.
bool isLevel(double rise, double along) noexcept {
    constexpr double steepest = 0.25, tremor = 0.05; // mm
    return std::abs(rise) <= steepest * along + tremor;
}

/// Replaces arcs about another axis than Z by chords: raised evenly they would no longer be arcs.
PathStroke raisable(const PathStroke& stroke) {
    constexpr double chord = 0.0005; // mm
    PathStroke chords = stroke;
    chords.points.clear();
    std::vector<glm::dvec3> ends;
    for (const StrokePoint& point : stroke.points) {
        if (!point.arc || point.arc->axis == 2 || chords.points.empty()) {
            chords.points.push_back(point);
            continue;
        }
        flatten(Arc{chords.points.back().pose.tip, point.pose.tip, point.arc->centre, point.arc->axis,
                    point.arc->clockwise},
                chord, ends);
        for (const glm::dvec3& end : ends) {
            chords.points.push_back(point);
            chords.points.back().pose.tip = end;
            chords.points.back().arc.reset();
        }
    }
    return chords;
}

/// The last point of the steep descent at the beginning of a stroke; 0 if there is none.
std::size_t endOfDescent(const PathStroke& stroke) {
    std::size_t end = 0;
    double across = 0.0;
    const double top = stroke.points.front().pose.tip.z;
    for (std::size_t i = 1; i < stroke.points.size(); ++i) {
        const glm::dvec3 move = stroke.points[i].pose.tip - stroke.points[i - 1].pose.tip;
        across += std::hypot(move.x, move.y);
        const double down = top - stroke.points[i].pose.tip.z;
        if (down > across)
            end = i;
        else if (across > down + 1.0)
            break;
    }
    return end;
}

PathStroke from(const PathStroke& stroke, std::size_t point) {
    return between(stroke, {point, 1.0}, {stroke.points.size() - 1, 1.0});
}

} // namespace

void beginAtBottom(PathStroke& stroke) {
    constexpr double straight = 0.02; // mm aside from its top: deviation of a smoothed vertical descent
    const glm::dvec3& top = stroke.points.front().pose.tip;
    std::size_t bottom = 0;
    while (bottom + 1 < stroke.points.size()) {
        const StrokePoint& next = stroke.points[bottom + 1];
        const bool down = next.pose.tip.z <= stroke.points[bottom].pose.tip.z && !next.arc;
        if (!down || std::hypot(next.pose.tip.x - top.x, next.pose.tip.y - top.y) > straight) break;
        ++bottom;
    }
    if (bottom + 1 == stroke.points.size()) return; // the stroke is only a descent
    stroke.points.erase(stroke.points.begin(), stroke.points.begin() + static_cast<std::ptrdiff_t>(bottom));
    stroke.points.front().arc.reset();
}

EntryPlanner::EntryPlanner(const Link& edit, const LinkRoom& room, const PartGuard& guard, const PathContext& context,
                           ShankWatch* watch)
    : on_(edit.entry == Link::Entry::ramp && context.tool.cutter.type != CutterType::drill)
    , mayPlunge_(context.tool.centreCutting)
    , slope_(std::tan(edit.rampAngle > 0.0                 ? edit.rampAngle
                      : context.conditions.rampAngle > 0.0 ? context.conditions.rampAngle
                                                           : usualAngle))
    , diameter_(context.tool.cutter.diameter)
    , stockTop_(context.stock.high.z)
    , safeHeight_(room.safeHeight())
    , room_(room)
    , guard_(guard)
    , context_(context)
    , watch_(watch) {}

double EntryPlanner::depthAt(const glm::dvec3& tip, bool all) const {
    if (tip.z >= stockTop_) return 0.0;
    const HeightMap& cleared = room_.cleared();
    const double free = all ? cleared.freeHeight(tip.x, tip.y)
                            : cleared.freeHeightWithin((0.5 - 0.5 * skimmedRim) * diameter_, tip.x, tip.y);
    const double known = free - tip.z; // never understated
    return known <= leastDepth || watch_ == nullptr ? known : std::min(known, watch_->depthAt(tip, known));
}

bool EntryPlanner::plunges(const glm::dvec3& from, const glm::dvec3& to) const {
    constexpr double look = 0.25; // mm
    if (!on_ || from.z - to.z <= slope_ * std::hypot(to.x - from.x, to.y - from.y) + leastDepth) return false;
    const int looks = static_cast<int>(std::ceil(glm::distance(from, to) / look));
    for (int i = 1; i <= looks; ++i) // a rib may stand between two free points
        if (depthAt(glm::mix(from, to, static_cast<double>(i) / looks)) > leastDepth) return true;
    return false;
}

bool EntryPlanner::meetsMaterial(const std::vector<StrokePoint>& way) const {
    return on_ &&
           std::ranges::any_of(way, [&](const StrokePoint& point) { return depthAt(point.pose.tip) > leastDepth; });
}

std::optional<EntryPlanner::Entry> EntryPlanner::into(const PathStroke& stroke, std::size_t first) const {
    if (!on_) return std::nullopt;
    Entry entry{EntryForm::plunge, first, {}, depthAt(stroke.points[first].pose.tip)};
    if (first == 0) {
        // A plunge by the hand: the bottom is reached first, then all of the stroke is made from its start.
        const std::size_t bottom = endOfDescent(stroke);
        PathStroke end = stroke;
        end.points = {stroke.points[bottom]};
        if (bottom > 0 && accessOf(end, guard_, safeHeight_).found) {
            entry.point = bottom;
            entry.depth = depthAt(stroke.points[bottom].pose.tip);
        }
    }
    if (entry.depth <= leastDepth) return std::nullopt;
    entry.depth = depthAt(stroke.points[entry.point].pose.tip, true);
    const PathStroke begun = from(stroke, entry.point);
    const double height = entry.depth + gap;
    const bool goesOn = entry.point == 0;
    const auto beyond = [&] { return rampInto(begun, height, goesOn ? RampEnd::turns : RampEnd::passes); };
    const auto helix = [&] { return helixInto(begun, entry.depth); };
    const std::size_t next = goesOn ? std::min<std::size_t>(1, stroke.points.size() - 1) : entry.point - 1;
    const auto beside = [&] { return rampBeside(begun, stroke.points[next].pose.tip); };
    const auto within = [&] { return rampInto(begun, height, RampEnd::noRoom); };
    struct Way {
        EntryForm form;
        bool hasRoom; ///< to turn into the stroke
        std::function<std::vector<StrokePoint>()> find;
    };
    const std::array<Way, 4> ways{{{EntryForm::ramp, true, beyond},
                                   {EntryForm::helix, true, helix},
                                   {EntryForm::ramp, true, beside},
                                   {EntryForm::ramp, false, within}}};
    for (const Way& way : ways) {
        entry.way = way.find();
        if (entry.way.empty() || !clearsShank(entry.way)) continue;
        entry.form = way.form;
        entry.stepsBack = goesOn && !way.hasRoom && turnBeyond(begun.points[0].pose.tip, begun.points[1].pose.tip);
        for (StrokePoint& point : entry.way) point.sample = stroke.points[entry.point].sample;
        return entry;
    }
    entry.way.clear();
    if (const std::optional<std::size_t> free = freePoint(stroke, std::max(entry.point, first) + 1)) {
        entry.point = *free;
        entry.depth = 0.0;
        return entry;
    }
    entry.point = first;
    return entry;
}

/// The first point, from `from` on, without material above it, from which the stroke can be followed back without a
/// plunge.
std::optional<std::size_t> EntryPlanner::freePoint(const PathStroke& stroke, std::size_t from) const {
    const std::vector<StrokePoint>& points = stroke.points;
    for (std::size_t i = 1; i < points.size(); ++i) {
        if (plunges(points[i].pose.tip, points[i - 1].pose.tip)) return std::nullopt;
        if (i < from || depthAt(points[i].pose.tip) > leastDepth) continue;
        PathStroke place = stroke;
        place.points = {points[i]};
        if (accessOf(place, guard_, safeHeight_).found) return i;
    }
    return std::nullopt;
}

/// Back and forth along the stroke's beginning, as often as the slope requires.
std::vector<StrokePoint> EntryPlanner::rampInto(const PathStroke& stroke, double height, RampEnd end) const {
    constexpr double looks = 0.05; // mm
    PathStroke line = raisable(stroke);
    std::optional<glm::dvec3> beyond;
    if (end != RampEnd::noRoom && line.points.size() > 1)
        beyond = turnBeyond(line.points[0].pose.tip, line.points[1].pose.tip);
    if (beyond) {
        line.points.insert(line.points.begin(), line.points.front());
        line.points.front().pose.tip = *beyond;
    }
    const std::vector<StrokeStep> steps = stepsOf(line, looks);
    std::size_t usable = 0;
    while (usable + 1 < steps.size() && steps[usable + 1].at <= longestLeg &&
           isLevel(steps[usable + 1].tip.z - steps[0].tip.z, steps[usable + 1].at))
        ++usable;
    const double longest = steps[usable].at, shortest = mayPlunge_ ? 0.5 * diameter_ : diameter_;
    if (longest < shortest) return {};
    const double length = height / slope_;
    const int turns = static_cast<int>(std::ceil(length / (2.0 * longest)));
    if (turns > mostTurns) return {};
    const double wanted = std::max(shortest, length / (2.0 * turns));
    std::size_t last = usable;
    while (last > 1 && steps[last - 1].at >= wanted) --last;
    const PathStroke forth = turnable(line, steps, last, usable), back = reversed(forth);
    const double whole = 2.0 * turns * lengthOf(forth);
    std::vector<StrokePoint> way;
    double at = 0.0;
    for (int leg = 0; leg < 2 * turns; ++leg) {
        const PathStroke& part = leg % 2 == 0 ? forth : back;
        const std::vector<StrokeStep> ends = stepsOf(part, 2.0 * longestLeg); // one per move
        for (std::size_t i = leg == 0 ? 0 : 1; i < ends.size(); ++i) {
            way.push_back(part.points[i]);
            way.back().pose.tip.z += height * std::max(0.0, 1.0 - (at + ends[i].at) / whole);
            way.back().removes = true;
            way.back().onBoundary = false;
        }
        at += ends.back().at;
    }
    way.front().arc.reset();
    if (beyond && end == RampEnd::passes) way.pop_back();
    if (beyond && end == RampEnd::turns) way.push_back(way.back());
    way.back().pose.tip = stroke.points.front().pose.tip;
    const LeadFinder finder({}, guard_, context_);
    return finder.isClear(way, stroke.required) ? way : std::vector<StrokePoint>();
}

/// Back and forth on a level line from the stroke's beginning, in any direction with enough room: along a wall that
/// leaves no room for a helix.
std::vector<StrokePoint> EntryPlanner::rampBeside(const PathStroke& stroke, const glm::dvec3& next) const {
    constexpr int directions = 16;
    constexpr double look = 0.25; // mm
    for (const double length : {diameter_, 0.5 * diameter_})
        for (int i = 0; i < directions; ++i) {
            const double angle = 2.0 * pi * i / directions;
            PathStroke line = stroke;
            line.points = {stroke.points.front(), stroke.points.front()};
            line.points.back().pose.tip += length * glm::dvec3(std::cos(angle), std::sin(angle), 0.0);
            if (isBackStep(line.points.back().pose.tip, line.points.front().pose.tip, next)) continue;
            double depth = 0.0;
            for (const StrokeStep& step : stepsOf(line, look)) depth = std::max(depth, depthAt(step.tip, true));
            std::vector<StrokePoint> way = rampInto(line, depth + gap, RampEnd::passes);
            // The last leg descends, too, which may add the last degree that makes its turn a back-step.
            if (way.size() < 2 || isBackStep(way[way.size() - 2].pose.tip, way.back().pose.tip, next)) continue;
            if (clearsShank(way)) return way;
        }
    return {};
}

/// The helix begins beside the stroke, where there may be more material than above the stroke's beginning.
std::vector<StrokePoint> EntryPlanner::helixInto(const PathStroke& stroke, double depth) const {
    for (int attempt = 0; attempt < 2; ++attempt) {
        LeadShape shape{LeadIn::Form::helix, helixShare * diameter_, depth + gap, std::atan(slope_)};
        shape.smallestShare = 0.5;
        std::vector<StrokePoint> way = LeadFinder(shape, guard_, context_).into(stroke);
        if (way.empty()) return way;
        const glm::dvec3& top = way.front().pose.tip;
        const double bottom = stroke.points.front().pose.tip.z, here = depthAt({top.x, top.y, bottom}, true);
        if (bottom + here <= top.z + leastDepth) return way;
        depth = here;
    }
    return {};
}

/// Whether shank and holder stay in empty space, tested in the stock itself.
bool EntryPlanner::clearsShank(const std::vector<StrokePoint>& way) const {
    const double lowest =
        std::ranges::min(way, {}, [](const StrokePoint& point) { return point.pose.tip.z; }).pose.tip.z;
    if (watch_ == nullptr || lowest + watch_->lowestGuard() >= stockTop_) return true;
    PathStroke stroke;
    stroke.points = way;
    watch_->keep();
    const glm::dvec3& start = way.front().pose.tip;
    glm::dvec3 at(start.x, start.y, safeHeight_);
    const std::vector<StrokeStep> steps = stepsOf(stroke, watch_->step());
    const bool clear = std::ranges::all_of(steps, [&](const StrokeStep& step) {
        const bool passes = !watch_->cutClear(at, step.tip);
        at = step.tip;
        return passes;
    });
    watch_->goBack();
    return clear;
}

} // namespace burin
