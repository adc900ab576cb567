// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/held_run.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace burin {
namespace {

/// Removes points from the end of a run that no longer belong to the path.
class HeldRunEnd {
public:
    explicit HeldRunEnd(std::vector<Held>& points) : points_(points), path_(points) {}

    /// @return the part of the path between the new end and the break
    std::vector<Held> settle() {
        constexpr double undisturbed = 0.01; // mm, hardly more than the clearance
        std::size_t kept = points_.size();
        while (kept > 0 && aside(kept - 1) > undisturbed) --kept;
        if (kept > 0) at_ = {kept - 1, 0.0};
        if (kept == 0 && !points_.empty() && aside(0) <= farthestAside) {
            at_ = {0, 0.0};
            kept = 1;
        }
        while (kept > 0 && kept < points_.size() && advances(kept)) ++kept;
        points_.resize(kept);
        return {path_.begin() + static_cast<std::ptrdiff_t>(kept > 0 ? at_.segment + 1 : 0), path_.end()};
    }

private:
    struct Place {
        std::size_t segment = 0;
        double share = -1.0; ///< of it
    };

    double aside(std::size_t index) const { return glm::distance(path_[index].point.pose.tip, path_[index].origin); }

    /// Whether a point is on the path farther along than the points before; its origin then becomes that point of the
    /// path.
    bool advances(std::size_t index) {
        const glm::dvec3& tip = points_[index].point.pose.tip;
        Place nearest;
        double least = farthestAside;
        // It was pushed there from near by: search beyond its own point of the path no farther than that distance.
        double beyond = 2.0 * aside(index) + farthestAside;
        for (std::size_t i = at_.segment; i + 1 < path_.size() && beyond >= 0.0; ++i) {
            const glm::dvec3 &from = path_[i].origin, way = path_[i + 1].origin - from;
            if (i >= index) beyond -= glm::length(way);
            const double square = glm::dot(way, way);
            const double share = square > 0.0 ? glm::clamp(glm::dot(tip - from, way) / square, 0.0, 1.0) : 0.0;
            const double distance = glm::distance(tip, from + share * way);
            if (distance > least) continue;
            least = distance;
            nearest = {i, share};
        }
        if (std::pair(nearest.segment, nearest.share) <= std::pair(at_.segment, at_.share)) return false;
        at_ = nearest;
        points_[index].origin = glm::mix(path_[at_.segment].origin, path_[at_.segment + 1].origin, at_.share);
        return true;
    }

    std::vector<Held>& points_;
    std::vector<Held> path_; ///< as it was before the edit
    Place at_;               ///< how far along it the run gets
};

void append(std::vector<Held>& path, std::vector<Held>& more) {
    std::ranges::move(std::exchange(more, {}), std::back_inserter(path));
}

/// The same at the start of a run.
std::vector<Held> settleStart(std::vector<Held>& points) {
    std::ranges::reverse(points);
    std::vector<Held> lost = HeldRunEnd(points).settle();
    std::ranges::reverse(points);
    std::ranges::reverse(lost);
    return lost;
}

/// Extends a run behind its last point along a gap, in ever shorter steps where it gets narrow; the gap gets shorter.
/// @param beyond where the path continues behind the gap; null: nowhere
void followInto(std::vector<Held>& gap, std::vector<Held>& points, const Held* beyond, const FollowPath& follow) {
    constexpr double shortest = 0.01; // mm
    std::vector<Held> path{points.back()};
    path.insert(path.end(), gap.begin(), gap.end());
    if (beyond != nullptr) path.push_back(*beyond);
    const std::size_t ends = gap.size() + 1; // end of the gap's points
    std::size_t i = 0;
    for (bool goesOn = true; goesOn && i + 1 < path.size(); i += goesOn ? 1 : 0) {
        const glm::dvec3 &from = path[i].origin, &to = path[i + 1].origin;
        const double length = glm::distance(from, to);
        double share = length > 0.0 ? 0.0 : 1.0;
        for (double step = 1.0; share < 1.0;) {
            const double next = std::min(1.0, share + step);
            const glm::dvec3 place = glm::mix(from, to, next);
            if (const auto tip = follow(points.back().point.pose.tip, place, (to - from) / length)) {
                points.push_back({path[i].point, place});
                points.back().point.pose.tip = *tip;
                share = next;
            } else if (step * length <= shortest) {
                break;
            } else {
                step *= 0.5;
            }
        }
        goesOn = share >= 1.0;
    }
    const std::size_t first = std::min(i + 1, ends);
    gap.assign(path.begin() + static_cast<std::ptrdiff_t>(first), path.begin() + static_cast<std::ptrdiff_t>(ends));
}

void followBack(std::vector<Held>& gap, std::vector<Held>& points, const Held* beyond, const FollowPath& follow) {
    std::ranges::reverse(gap);
    std::ranges::reverse(points);
    followInto(gap, points, beyond, follow);
    std::ranges::reverse(points);
    std::ranges::reverse(gap);
}

/// Runs that have points; each gets all losses before it, the last one also those behind it.
std::vector<HeldRun> withoutEmpty(std::vector<HeldRun>& runs) {
    std::vector<HeldRun> left;
    std::vector<Held> lost;
    for (HeldRun& run : runs) {
        append(lost, run.before);
        if (!run.points.empty()) {
            run.before = std::exchange(lost, {});
            left.push_back({std::move(run.points), std::move(run.before), {}});
        }
        append(lost, run.behind);
    }
    if (left.empty()) left.emplace_back();
    left.back().behind = std::move(lost);
    return left;
}

} // namespace

double originLength(const HeldRun& run) {
    double length = 0.0;
    for (std::size_t i = 1; i < run.points.size(); ++i)
        length += glm::distance(run.points[i - 1].origin, run.points[i].origin);
    return length;
}

void settleBreaks(std::vector<HeldRun>& runs, const FollowPath& follow) {
    if (runs.size() < 2) return;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        if (i + 1 < runs.size()) runs[i].behind = HeldRunEnd(runs[i].points).settle();
        if (i > 0) runs[i].before = settleStart(runs[i].points);
    }
    runs = withoutEmpty(runs);
    if (runs.front().points.empty()) return;
    if (!runs.front().before.empty()) followBack(runs.front().before, runs.front().points, nullptr, follow);
    for (std::size_t i = 1; i < runs.size(); ++i) {
        followInto(runs[i].before, runs[i - 1].points, &runs[i].points.front(), follow);
        followBack(runs[i].before, runs[i].points, &runs[i - 1].points.back(), follow);
    }
    if (!runs.back().behind.empty()) followInto(runs.back().behind, runs.back().points, nullptr, follow);
}

} // namespace burin
