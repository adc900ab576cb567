// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/path_comparison.h"

#include "core/base/numbers.h"
#include "core/base/parallel.h"
#include "core/base/parallel_progress.h"
#include "core/base/units.h"
#include "core/geometry/arc.h"
#include "core/geometry/segment_tree.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace burin {

namespace {

constexpr std::size_t comparedMoves = 64; // moves that a thread processes at a time

/// Returns the cuts of a path as straight segments, in the order of the path.
std::vector<StraightSegment> cutsOf(const Path& path) {
    std::vector<StraightSegment> cuts;
    std::vector<glm::dvec3> corners;
    for (std::size_t i = 1; i < path.points.size(); ++i) {
        const PathPoint& point = path.points[i];
        if (point.kind != MoveKind::cut) continue;
        glm::dvec3 from = path.points[i - 1].pose.tip;
        corners.assign(1, point.pose.tip);
        if (point.arc)
            flatten({from, point.pose.tip, point.arc->centre, point.arc->axis, point.arc->clockwise}, comparedChord,
                    corners);
        for (const glm::dvec3& to : corners) cuts.push_back({std::exchange(from, to), to});
    }
    return cuts;
}

/// Accumulates the deviation, position by position along the cuts.
class Deviating {
public:
    Deviating(const SegmentTree& others, double tolerance) : others_(others), tolerance_(tolerance) {}

    void walk(const StraightSegment& cut, const Progress& progress) {
        const double length = glm::distance(cut.from, cut.to);
        const double pieces = std::max(1.0, std::ceil(length / comparedSpacing));
        Place last = look(cut.from);
        for (double piece = 1.0; piece <= pieces && !progress.cancelled(); piece += 1.0) {
            const Place next = look(piece == pieces ? cut.to : glm::mix(cut.from, cut.to, piece / pieces));
            addPiece(last, next, length / pieces);
            last = next;
        }
    }
    /// Returns the accumulated deviation; `mean` is still the integral along the length, mm².
    PathDeviation take() { return std::move(sum_); }

private:
    struct Place {
        glm::dvec3 at{0.0};
        double distance = 0.0; ///< mm
    };

    Place look(const glm::dvec3& at) {
        const double distance = others_.distance(at, near_);
        if (!any_ || distance > sum_.largest) {
            sum_.largest = distance;
            sum_.largestAt = at;
            any_ = true;
        }
        return {at, distance};
    }

    /// The distance is interpolated linearly between the ends of a piece.
    void addPiece(const Place& from, const Place& to, double length) {
        sum_.length += length;
        sum_.mean += 0.5 * length * (from.distance + to.distance);
        const bool begins = from.distance > tolerance_, ends = to.distance > tolerance_;
        if (!begins && !ends) return;
        const double crossing = begins == ends ? 0.0 : (tolerance_ - from.distance) / (to.distance - from.distance);
        const double first = begins ? 0.0 : crossing, last = ends ? 1.0 : crossing;
        sum_.farther += (last - first) * length;
        addPart(glm::mix(from.at, to.at, first), glm::mix(from.at, to.at, last));
    }

    void addPart(const glm::dvec3& from, const glm::dvec3& to) {
        std::vector<std::vector<glm::dvec3>>& parts = sum_.fartherParts;
        if (parts.empty() || parts.back().back() != from) parts.push_back({from});
        if (to != from) parts.back().push_back(to);
    }

    const SegmentTree& others_;
    double tolerance_;
    std::uint32_t near_ = 0;
    PathDeviation sum_;
    bool any_ = false;
};

/// Appends the deviation of the next part of the path.
void append(PathDeviation& sum, PathDeviation next) {
    if (next.largest > sum.largest) {
        sum.largest = next.largest;
        sum.largestAt = next.largestAt;
    }
    sum.mean += next.mean;
    sum.length += next.length;
    sum.farther += next.farther;
    auto parts = next.fartherParts.begin();
    if (parts != next.fartherParts.end() && !sum.fartherParts.empty() &&
        sum.fartherParts.back().back() == parts->front()) {
        sum.fartherParts.back().insert(sum.fartherParts.back().end(), parts->begin() + 1, parts->end());
        ++parts;
    }
    std::move(parts, next.fartherParts.end(), std::back_inserter(sum.fartherParts));
}

/// Reduces a part to its ends and corners: points within straight lines are redundant.
void dropStraight(std::vector<glm::dvec3>& part) {
    constexpr double straight = 1e-9; // mm, distance from the line
    if (part.size() < 3) return;
    std::vector<glm::dvec3> corners{part.front()};
    for (std::size_t i = 1; i + 1 < part.size(); ++i) {
        const glm::dvec3 along = part[i + 1] - corners.back();
        const glm::dvec3 off = glm::cross(part[i] - corners.back(), along);
        const bool forward = glm::dot(part[i] - corners.back(), part[i + 1] - part[i]) > 0.0;
        if (!forward || glm::length(off) > straight * glm::length(along)) corners.push_back(part[i]);
    }
    corners.push_back(part.back());
    part = std::move(corners);
}

/// @param cuts, others must not be empty
PathDeviation deviationOf(const std::vector<StraightSegment>& cuts, const SegmentTree& others, double tolerance,
                          Progress& progress) {
    const std::size_t count = (cuts.size() + comparedMoves - 1) / comparedMoves;
    std::vector<PathDeviation> done(count);
    {
        ParallelProgress reported(progress, count);
        parallelFor(std::size_t{0}, count, [&](std::size_t chunk) {
            Deviating deviating(others, tolerance);
            const std::size_t end = std::min(cuts.size(), (chunk + 1) * comparedMoves);
            for (std::size_t i = chunk * comparedMoves; i < end; ++i) deviating.walk(cuts[i], progress);
            done[chunk] = deviating.take();
            for (std::vector<glm::dvec3>& part : done[chunk].fartherParts) dropStraight(part);
            reported.add();
        });
    }
    PathDeviation all = std::move(done.front());
    for (std::size_t i = 1; i < count; ++i) append(all, std::move(done[i]));
    if (all.length > 0.0) all.mean /= all.length;
    return all;
}

} // namespace

PathTotals totalsOf(const Path& path) {
    PathTotals totals;
    totals.points = path.points.size();
    double time = 0.0;
    bool known = true;
    for (std::size_t i = 1; i < path.points.size(); ++i) {
        const PathPoint& point = path.points[i];
        const double length = lengthOf(path.points[i - 1].pose.tip, point);
        if (point.arc) ++totals.arcs;
        if (point.kind == MoveKind::cut)
            totals.cutting += length;
        else if (point.kind == MoveKind::plunge)
            totals.plunging += length;
        else
            totals.air += length;
        if (point.kind == MoveKind::rapid || length == 0.0) continue;
        known = known && point.feed > 0.0;
        if (point.feed > 0.0) time += secondsPerMinute * length / point.feed;
    }
    if (known) totals.feedTime = time;
    return totals;
}

Result<PathDifference> differenceOf(const Path& first, const Path& second, double tolerance, Progress& progress) {
    if (!(tolerance >= comparedTolerances.low && tolerance <= comparedTolerances.high))
        return Error{ErrorCode::argumentInvalid, "tolerance", formatShortest(tolerance),
                     formatShortest(comparedTolerances.low) + " … " + formatShortest(comparedTolerances.high) + " mm"};
    PathDifference comparison{tolerance, totalsOf(first), totalsOf(second), {}, {}};
    const std::vector<StraightSegment> cuts = cutsOf(first), others = cutsOf(second);
    if (!cuts.empty() && !others.empty()) {
        {
            const ProgressPart part(progress, 0.0, 0.5);
            comparison.ofFirst = deviationOf(cuts, SegmentTree(others), tolerance, progress);
        }
        if (progress.cancelled()) return Error{ErrorCode::cancelled, "path", {}, {}};
        const ProgressPart part(progress, 0.5, 1.0);
        comparison.ofSecond = deviationOf(others, SegmentTree(cuts), tolerance, progress);
    }
    if (progress.cancelled()) return Error{ErrorCode::cancelled, "path", {}, {}};
    return comparison;
}

} // namespace burin
