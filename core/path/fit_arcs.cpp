// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/parallel.h"
#include "core/path/arc_fit.h"
#include "core/path/back_steps.h"
#include "core/path/part_guard.h"
#include "core/path/polyline.h"
#include "core/path/stroke_steps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numeric>

namespace burin {
namespace {

/// The least number of moves that an arc has to replace.
constexpr std::size_t fewestMoves = 3;
/// Share of the tolerance by which back-steps may be removed.
constexpr double backStepShare = 0.5;

/// A line or an arc to one of a stroke's points.
struct Primitive {
    std::size_t end = 0;
    std::optional<PathArc> arc{};
    Deviation deviation;
};

class Fitter {
public:
    Fitter(const ArcFitRules& rules, const PartGuard& guard, const PathStroke& stroke)
        : rules_(rules), guard_(guard), required_(stroke.required), points_(stroke.points) {}

    /// The primitives that replace the points from `first` to `last`, both included.
    std::vector<Primitive> fit(std::size_t first, std::size_t last, const Progress& progress) const {
        std::vector<Primitive> primitives;
        while (first < last && !progress.cancelled()) {
            Primitive best = longest(first, first + 1, last, [&](std::size_t end) { return line(first, end); });
            for (const int axis : axesOfArcs()) {
                const std::size_t nearest = std::max(first + fewestMoves, best.end + 1); // an arc has to reach farther
                const auto make = [&](std::size_t end) { return arcTo(first, end, axis); };
                const Primitive arc = longest(first, firstArc(first, nearest, last, make), last, make);
                if (arc.end > best.end) best = arc;
            }
            first = best.end;
            primitives.push_back(std::move(best));
        }
        return primitives;
    }

private:
    using Found = std::optional<Primitive>;

    /// Empty if the control has no arcs.
    std::span<const int> axesOfArcs() const noexcept {
        static constexpr std::array axes{2, 1, 0};
        return std::span(axes).first(rules_.largestSweep > 0.0 ? axes.size() : 0);
    }

    std::span<const StrokePoint> interval(std::size_t first, std::size_t end) const {
        return std::span(points_).subspan(first, end - first + 1);
    }

    /// The farthest primitive that is possible: the distance is doubled as long as that works, then bisected. Empty if
    /// not even the nearest is possible. Primitives that obey the rules are checked against the part.
    template <class Make>
    Primitive longest(std::size_t first, std::size_t nearest, std::size_t last, const Make& make) const {
        Primitive best;
        best.end = first;
        std::size_t beyond = last + 1;
        for (std::size_t end = nearest; end <= last && end != best.end;) {
            Found found = make(end);
            if (found && isClear(first, *found))
                best = std::move(*found);
            else
                beyond = end;
            if (best.end == first) break;
            end = beyond > last ? std::min(2 * best.end - first, last) : best.end + (beyond - best.end) / 2;
        }
        return best;
    }

    /// The point from which to search for the farthest arc: with tremor, an arc to one of the next points often passes
    /// none of them, whereas one to a later point does.
    template <class Make>
    std::size_t firstArc(std::size_t first, std::size_t nearest, std::size_t last, const Make& make) const {
        constexpr std::size_t least = 6; // points that are tried, in addition to as many as the distance to it
        if (nearest > last) return nearest;
        for (std::size_t end = std::min(last, nearest + least + (nearest - first)); end > nearest; --end) {
            const Found found = make(end);
            if (found && isClear(first, *found)) return end;
        }
        return nearest;
    }

    Found line(std::size_t first, std::size_t end) const {
        Primitive primitive;
        primitive.end = end;
        const glm::dvec3 &from = points_[first].pose.tip, &to = points_[end].pose.tip;
        for (std::size_t i = first + 1; i < end; ++i) {
            primitive.deviation.include(distanceToSegment(points_[i].pose.tip, from, to), points_[i].pose.tip);
            if (primitive.deviation.distance > rules_.tolerance) return {};
        }
        return primitive;
    }

    Found arcTo(std::size_t first, std::size_t end, int axis) const {
        const auto fitted = fitArc(interval(first, end), axis, rules_);
        if (!fitted) return {};
        return Primitive{end, PathArc{fitted->arc.centre, axis, fitted->arc.clockwise}, fitted->deviation};
    }

    bool isClear(std::size_t first, const Primitive& primitive) const {
        if (primitive.end == first + 1) return true; // the original move
        const glm::dvec3 &from = points_[first].pose.tip, &to = points_[primitive.end].pose.tip;
        if (!primitive.arc) return guard_.isClear(from, to, required_, defaultSampling);
        const PathArc& arc = *primitive.arc;
        return guard_.isClear({from, to, arc.centre, arc.axis, arc.clockwise}, required_, defaultSampling);
    }

    const ArcFitRules& rules_;
    const PartGuard& guard_;
    double required_; // mm from the part
    const std::vector<StrokePoint>& points_;
};

/// Intervals that threads share: groups of points, and within one neither an existing arc nor a change of the coolant
/// that a program states: no line replaces moves on either side of it.
std::vector<std::pair<std::size_t, std::size_t>> groupsOf(const PathStroke& stroke, const StatedFeeds* stated) {
    const std::vector<StrokePoint>& points = stroke.points;
    std::vector<std::pair<std::size_t, std::size_t>> groups;
    std::size_t first = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const bool ends = i + 1 == points.size() || points[i].arc || points[i + 1].arc || i - first == simplifyGroup ||
                          (stated != nullptr && stated->coolantChangesAt({stroke.source, points[i].sample}));
        if (!ends) continue;
        groups.emplace_back(first, i);
        first = i;
    }
    return groups;
}

/// Removes back-steps first, as no arc and no line is fitted across one; the rest of the tolerance is left for the fit.
Deviation dropBackSteps(PathStroke& stroke, double tolerance, const PartGuard& guard, const Progress& progress) {
    const auto staysClear = [&](const glm::dvec3& from, const glm::dvec3& to) {
        return !progress.cancelled() && guard.isClear(from, to, stroke.required, defaultSampling);
    };
    std::vector<std::size_t> kept(stroke.points.size());
    std::iota(kept.begin(), kept.end(), std::size_t{0});
    const Deviation dropped = dropBackSteps(stroke.points, kept, tolerance, staysClear, progress);
    if (!progress.cancelled()) keepOnly(stroke.points, kept);
    return dropped;
}

/// The direction in which the tool leaves the start of a move, or arrives at its end; null if it does not move.
glm::dvec3 headingOf(const glm::dvec3& from, const StrokePoint& to, bool atEnd) {
    constexpr double share = 1e-3; // of the arc: such a chord is within one or two mrad of the tangent
    if (!to.arc) return to.pose.tip - from;
    const Arc arc{from, to.pose.tip, to.arc->centre, to.arc->axis, to.arc->clockwise};
    const ArcTurn turn = turnOf(arc);
    return atEnd ? to.pose.tip - placeOn(arc, turn, 1.0 - share) : placeOn(arc, turn, share) - from;
}

/// Whether the corner between two moves is nearly a back-step, arcs included: the first chord of a small arc has
/// already turned by some degrees.
bool stepsBack(const glm::dvec3& from, const StrokePoint& at, const StrokePoint& to) {
    constexpr double nearlyBack = backStepTurn - 15.0 * pi / 180.0;
    if (std::min(lengthTo(at, from), lengthTo(to, at.pose.tip)) >= longestBackStep) return false;
    const glm::dvec3 in = headingOf(from, at, true), out = headingOf(at.pose.tip, to, false);
    return glm::dot(in, out) < std::cos(nearlyBack) * glm::length(in) * glm::length(out);
}

/// Turns an arc that was fitted at a back-step into lines again, of which linking can leave points out; also an arc
/// that leaves no more than a short move up to the point where the tool turns back. @return whether there was one
bool straightenBackSteps(std::vector<Primitive>& whole, const std::vector<StrokePoint>& points, const Fitter& lines,
                         const Progress& progress) {
    const auto startOf = [&](std::size_t i) { return i == 0 ? std::size_t{0} : whole[i - 1].end; };
    const auto madeOf = [&](std::size_t i) {
        StrokePoint end = points[whole[i].end];
        end.arc = whole[i].arc;
        return end;
    };
    const auto isFitted = [&](std::size_t i) { return whole[i].arc && whole[i].end > startOf(i) + 1; };
    bool any = false;
    std::vector<bool> straight(whole.size(), false);
    const auto isShort = [&](std::size_t i) {
        return lengthTo(madeOf(i), points[startOf(i)].pose.tip) < longestBackStep;
    };
    for (std::size_t i = 0; i + 1 < whole.size(); ++i) {
        if (!stepsBack(points[startOf(i)].pose.tip, madeOf(i), madeOf(i + 1))) continue;
        for (const std::size_t arc : {i, i + 1, i - 1, i + 2}) {
            if (arc >= whole.size() || !isFitted(arc)) continue; // the first move has no move before it
            const bool leavesAShortMove = (arc == i - 1 && isShort(i)) || (arc == i + 2 && isShort(i + 1));
            if (arc != i && arc != i + 1 && !leavesAShortMove) continue;
            any = straight[arc] = true;
            break;
        }
    }
    std::vector<Primitive> changed;
    for (std::size_t i = 0; i < whole.size(); ++i) {
        if (straight[i])
            std::ranges::move(lines.fit(startOf(i), whole[i].end, progress), std::back_inserter(changed));
        else
            changed.push_back(whole[i]);
    }
    whole = std::move(changed);
    return any;
}

Deviation fitStroke(PathStroke& stroke, ArcFitRules rules, const PartGuard& guard, const StatedFeeds* stated,
                    const Progress& progress) {
    Deviation deviation;
    if (stroke.points.size() < 2) return deviation;
    const Deviation dropped = dropBackSteps(stroke, backStepShare * rules.tolerance, guard, progress);
    rules.tolerance -= dropped.distance;
    const auto groups = groupsOf(stroke, stated);
    const Fitter fitter(rules, guard, stroke);
    std::vector<std::vector<Primitive>> fitted(groups.size());
    parallelFor(std::size_t{0}, groups.size(), [&](std::size_t i) {
        const auto [first, last] = groups[i];
        if (stroke.points[last].arc)
            fitted[i] = {Primitive{last, stroke.points[last].arc, {}}};
        else
            fitted[i] = fitter.fit(first, last, progress);
    });
    if (progress.cancelled()) return deviation;
    std::vector<Primitive> whole;
    for (std::vector<Primitive>& group : fitted) std::ranges::move(group, std::back_inserter(whole));
    ArcFitRules straight = rules;
    straight.largestSweep = 0.0; // no arcs
    const Fitter lines(straight, guard, stroke);
    while (straightenBackSteps(whole, stroke.points, lines, progress)) {
    }
    if (progress.cancelled()) return deviation;
    std::vector<std::size_t> kept{0};
    std::vector<std::optional<PathArc>> arcs{{}};
    for (const Primitive& primitive : whole) {
        kept.push_back(primitive.end);
        arcs.push_back(primitive.arc);
        deviation.include(primitive.deviation);
    }
    keepOnly(stroke.points, kept);
    for (std::size_t i = 0; i < arcs.size(); ++i) stroke.points[i].arc = arcs[i];
    // Both happened in sequence, so their sum bounds the total deviation.
    return {deviation.distance + dropped.distance, deviation.distance > 0.0 ? deviation.place : dropped.place};
}

} // namespace

Result<Deviation> apply(const FitArcs& edit, PathUnderEdit& state, const PathContext& context, Progress& progress) {
    const Result<PartGuard> guard = PartGuard::of(context);
    if (!guard) return guard.error();
    ArcFitRules rules;
    rules.tolerance = edit.tolerance;
    const ArcRules& control = context.machine.arcs;
    rules.largestSweep = std::min(edit.largestSweep, control.largestSweep);
    rules.smallestRadius = std::max(edit.smallestRadius, control.smallestRadius);
    rules.largestRadius = std::min(edit.largestRadius, control.largestRadius);
    rules.radiusMismatch = std::min(edit.radiusMismatch, control.radiusMismatch);
    rules.figure = std::pow(10.0, -context.machine.coordinateDecimals);
    rules.programZero = context.workOffset;
    return changeEach(state, progress, [&](PathStroke& stroke) {
        return fitStroke(stroke, rules, *guard, state.stated.get(), progress);
    });
}

} // namespace burin
