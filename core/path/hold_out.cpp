// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/apply.h"

#include "core/base/parallel.h"
#include "core/path/held_run.h"
#include "core/path/part_guard.h"
#include "core/path/polyline.h"
#include "core/path/stroke_steps.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace burin {
namespace {

/// Points that carry no shape are dropped first: fewer points to push, with the path within this distance, mm.
constexpr double thinning = 0.002;
/// Number of moves per piece of work that threads share.
constexpr std::size_t pieceLength = 500;
/// A move shorter than this that still enters is led over the obstacle instead of around it, mm.
constexpr double shortestMove = 0.02;
/// The same happens after this many halvings of a move.
constexpr int deepest = 16;
/// Compensates for rounding between the aim and the result of the next query, mm.
constexpr double surplus = 1e-6;

/// Points are pushed slightly farther than moves have to stay away: otherwise an arc around a convex part would need
/// ever more points.
double requiredBetween(const HoldOut& edit, double allowance) {
    return allowance + std::min(0.25 * edit.clearance, 0.001);
}

/// The distance that strokes of a tool keep from the part, mm: a drill fits its hole, whose facets lie inside it.
double heldAllowance(const PathStroke& stroke, const Tool& tool) noexcept {
    return stroke.allowance - (tool.cutter.type == CutterType::drill ? drillFit : 0.0);
}

/// Consecutive held points.
struct Chain {
    std::vector<Held> points;
    std::vector<std::size_t> breaks; ///< indices of points that no clear motion reaches from the point before
};

class Holder {
public:
    Holder(const PartGuard& guard, const HoldOut& edit, double allowance)
        : guard_(guard)
        , sampling_(edit.sampling)
        , aim_(allowance + edit.clearance)
        , required_(requiredBetween(edit, allowance)) {}

    /// Moves the tip out along the gradient of the clearance, or up where that does not help.
    void push(glm::dvec3& tip) const {
        constexpr int attempts = 30; // in a groove each wall cancels part of what the other one gained
        glm::dvec3 place = tip;
        for (int i = 0; i < attempts; ++i) {
            const ToolClearance found = guard_.clearance(place, aim_ + surplus);
            if (found.clearance >= aim_) {
                tip = place;
                return;
            }
            place += (aim_ - found.clearance + surplus) * found.away;
        }
        lift(tip);
    }

    /// Adds the points to a chain that are needed between two held points so that each move is clear, both ends
    /// excluded. If nothing helps, the chain is broken, in as short an interval as possible.
    void bridge(const Held& from, const Held& to, Chain& chain, int depth = 0) const {
        const auto dip = guard_.deepestDip(from.point.pose.tip, to.point.pose.tip, required_, sampling_);
        if (!dip) return;
        const double length = glm::distance(from.point.pose.tip, to.point.pose.tip);
        if (length < shortestMove || depth > deepest) {
            if (!leadOver(from, to, chain.points)) chain.breaks.push_back(chain.points.size());
            return;
        }
        // Near an end the dip is split more towards the middle, otherwise the halves would not get shorter.
        const double part = std::clamp(dip->part, 0.1, 0.9);
        Held middle;
        middle.point = from.point;
        middle.point.removes = middle.point.onBoundary = false;
        middle.point.pose.tip = glm::mix(from.point.pose.tip, to.point.pose.tip, part);
        middle.origin = glm::mix(from.origin, to.origin, part);
        push(middle.point.pose.tip);
        bridge(from, middle, chain, depth + 1);
        chain.points.push_back(middle);
        bridge(middle, to, chain, depth + 1);
    }

    /// The pushed-out tip for a point of the path, if it is near, not behind, and reached by a clear move.
    /// @param along unit, of the path
    std::optional<glm::dvec3> follow(const glm::dvec3& from, const glm::dvec3& place, const glm::dvec3& along) const {
        constexpr double behind = 0.02; // mm
        glm::dvec3 tip = place;
        push(tip);
        if (glm::distance(tip, place) > farthestAside || glm::dot(place - tip, along) > behind ||
            !guard_.isClear(from, tip, required_, sampling_))
            return std::nullopt;
        return tip;
    }

private:
    /// Straight up, to the first height found that is clear; above the part at the latest.
    void lift(glm::dvec3& tip) const {
        const double last = std::max(guard_.top() + aim_ + surplus, tip.z);
        double step = 0.01;
        while (tip.z < last) {
            const double missing = aim_ - guard_.clearance(tip, aim_ + surplus).clearance;
            if (missing <= 0.0) return;
            tip.z = std::min(last, tip.z + std::max(missing, step) + surplus);
            step *= 1.5;
        }
    }

    /// Up, across and down.
    bool leadOver(const Held& from, const Held& to, std::vector<Held>& between) const {
        const double low = std::max(from.point.pose.tip.z, to.point.pose.tip.z);
        const double last = std::max(guard_.top() + aim_ + surplus, low);
        double height = low;
        for (double step = 0.01; height <= last; step *= 1.5) {
            height = height < last ? std::min(last, height + step) : height + step;
            Held up = from, across = to;
            up.point.removes = up.point.onBoundary = false;
            across.point.removes = across.point.onBoundary = false;
            across.point.sample = from.point.sample;
            up.point.pose.tip.z = across.point.pose.tip.z = height;
            if (guard_.isClear(from.point.pose.tip, up.point.pose.tip, required_, sampling_) &&
                guard_.isClear(up.point.pose.tip, across.point.pose.tip, required_, sampling_) &&
                guard_.isClear(across.point.pose.tip, to.point.pose.tip, required_, sampling_)) {
                between.push_back(up);
                between.push_back(across);
                return true;
            }
        }
        return false;
    }

    const PartGuard& guard_;
    double sampling_;
    double aim_;      // mm, for points that had to be pushed
    double required_; // mm, for every point of every move
};

/// An interval of one stroke: from one of its points to another, both included.
struct Piece {
    std::size_t stroke = 0, first = 0, last = 0;
    Chain chain; ///< all held points behind the first one
};

std::vector<Piece> piecesOf(const std::vector<std::vector<Held>>& strokes) {
    std::vector<Piece> pieces;
    for (std::size_t s = 0; s < strokes.size(); ++s) {
        for (std::size_t i = 0; i + 1 < strokes[s].size(); i += pieceLength)
            pieces.push_back({s, i, std::min(i + pieceLength, strokes[s].size() - 1), {}});
    }
    return pieces;
}

void hold(Piece& piece, const std::vector<Held>& points, const Holder& holder) {
    for (std::size_t i = piece.first; i < piece.last; ++i) {
        holder.bridge(points[i], points[i + 1], piece.chain);
        piece.chain.points.push_back(points[i + 1]);
    }
}

/// Turns the runs of a broken stroke into strokes; gaps between them, and runs too short to be worth a link, are
/// reported as left out.
class Breaker {
public:
    Breaker(PathUnderEdit& state, double shortest) : state_(state), shortest_(shortest) {}

    std::vector<PathStroke> strokesOf(const PathStroke& stroke, const std::vector<HeldRun>& runs) {
        std::vector<PathStroke> strokes;
        PathStroke gap = stroke; // as the path was before
        gap.points.clear();
        for (const HeldRun& run : runs) {
            addTo(gap, run.before);
            const bool whole = runs.size() == 1 && run.before.empty() && run.behind.empty();
            const bool kept = whole || (!run.points.empty() && originLength(run) >= shortest_);
            if (kept) {
                gap.points.push_back(atOrigin(run.points.front()));
                report(gap);
                strokes.push_back(strokeOf(stroke, run));
                gap.points = {atOrigin(run.points.back())};
            } else {
                addTo(gap, run.points);
            }
            addTo(gap, run.behind);
        }
        report(gap);
        return strokes;
    }

    Deviation pushed; ///< of the parts that are kept

private:
    static StrokePoint atOrigin(const Held& held) {
        StrokePoint point = held.point;
        point.pose.tip = held.origin;
        return point;
    }
    static void addTo(PathStroke& gap, const std::vector<Held>& lost) {
        for (const Held& held : lost) gap.points.push_back(atOrigin(held));
    }
    PathStroke strokeOf(const PathStroke& stroke, const HeldRun& run) {
        PathStroke part = stroke;
        part.points.clear();
        for (const Held& held : run.points) {
            part.points.push_back(held.point);
            pushed.include(glm::distance(held.point.pose.tip, held.origin), held.origin);
        }
        return part;
    }
    void report(const PathStroke& gap) {
        constexpr double nothing = 1e-3; // mm
        if (lengthOf(gap) > nothing) state_.omissions.push_back(omissionOf(gap, OmissionReason::part));
    }

    PathUnderEdit& state_;
    double shortest_; // mm
};

/// The runs of each stroke.
std::vector<std::vector<HeldRun>> runsOf(const std::vector<std::vector<Held>>& strokes,
                                         const std::vector<Piece>& pieces) {
    std::vector<std::vector<HeldRun>> runs(strokes.size());
    for (std::size_t s = 0; s < strokes.size(); ++s)
        if (!strokes[s].empty()) runs[s] = {{{strokes[s].front()}, {}, {}}};
    for (const Piece& piece : pieces) {
        auto next = piece.chain.breaks.begin();
        for (std::size_t i = 0; i < piece.chain.points.size(); ++i) {
            if (next != piece.chain.breaks.end() && *next == i) {
                runs[piece.stroke].emplace_back();
                ++next;
            }
            runs[piece.stroke].back().points.push_back(piece.chain.points[i]);
        }
    }
    return runs;
}

} // namespace

Result<Deviation> apply(const HoldOut& edit, PathUnderEdit& state, const PathContext& context, Progress& progress) {
    const Result<PartGuard> guard = PartGuard::of(context);
    if (!guard) return guard.error();
    const auto anyShortcut = [](const glm::dvec3&, const glm::dvec3&) { return true; };
    Deviation thinned;
    std::vector<std::vector<Held>> strokes(state.strokes.size());
    for (std::size_t s = 0; s < strokes.size(); ++s) {
        std::vector<StrokePoint>& points = state.strokes[s].points;
        const std::vector<std::size_t> kept = simplifyInGroups(points, thinning, anyShortcut, progress);
        if (progress.cancelled()) return Error{ErrorCode::cancelled, "path", "", ""};
        thinned.include(thinnedDeviation(points, kept));
        keepOnly(points, kept);
        const Holder holder(*guard, edit, heldAllowance(state.strokes[s], context.tool));
        strokes[s].resize(points.size());
        parallelFor(std::size_t{0}, points.size(), [&](std::size_t i) {
            strokes[s][i] = {points[i], points[i].pose.tip};
            if (!progress.cancelled()) holder.push(strokes[s][i].point.pose.tip);
        });
    }
    std::vector<Piece> pieces = piecesOf(strokes);
    parallelFor(std::size_t{0}, pieces.size(), [&](std::size_t i) {
        Piece& piece = pieces[i];
        const Holder holder(*guard, edit, heldAllowance(state.strokes[piece.stroke], context.tool));
        if (!progress.cancelled()) hold(piece, strokes[piece.stroke], holder);
    });
    if (progress.cancelled()) return Error{ErrorCode::cancelled, "path", "", ""};
    std::vector<std::vector<HeldRun>> runs = runsOf(strokes, pieces);
    Breaker breaker(state, shortestKept(context.tool.cutter.diameter));
    std::vector<PathStroke> held;
    for (std::size_t s = 0; s < runs.size(); ++s) {
        state.lengthBefore += lengthOf(state.strokes[s]);
        const Holder holder(*guard, edit, heldAllowance(state.strokes[s], context.tool));
        settleBreaks(runs[s], [&](const auto& from, const auto& to, const auto& along) {
            return holder.follow(from, to, along);
        });
        state.strokes[s].required = requiredBetween(edit, heldAllowance(state.strokes[s], context.tool));
        std::ranges::move(breaker.strokesOf(state.strokes[s], runs[s]), std::back_inserter(held));
    }
    state.strokes = std::move(held);
    // Both happened in sequence, so their sum bounds the total deviation.
    const Deviation& pushed = breaker.pushed;
    return Deviation{thinned.distance + pushed.distance, pushed.distance > 0.0 ? pushed.place : thinned.place};
}

} // namespace burin
