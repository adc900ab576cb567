// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/hand_stretch.h"

#include "core/geometry/arc.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin {

namespace {

PathPoint pointBetween(const PathPoint& from, const PathPoint& to, std::int64_t tick) {
    const double share = static_cast<double>(tick - from.sample) / static_cast<double>(to.sample - from.sample);
    PathPoint point = to;
    point.sample = tick;
    point.pose.tip = glm::mix(from.pose.tip, to.pose.tip, share);
    if (to.arc) {
        const Arc arc{from.pose.tip, to.pose.tip, to.arc->centre, to.arc->axis, to.arc->clockwise};
        point.pose.tip = placeOn(arc, turnOf(arc), share);
    }
    return point;
}

/// Ends of an interval that a move passes between its own ends, in the order in which it passes them.
std::vector<std::int64_t> endsPassed(const PathPoint& from, const PathPoint& to, const SourceStretch& stretch) {
    std::vector<std::int64_t> passed;
    if (!hasMoment(from) || !hasMoment(to) || from.source != to.source || stretch.source != from.source) return passed;
    if (to.kind == MoveKind::rapid) return passed; // across a part that the path leaves out
    const auto [low, high] = std::minmax(from.sample, to.sample);
    for (const std::int64_t tick : {stretch.first, stretch.last})
        if (low < tick && tick < high && (passed.empty() || passed.back() != tick)) passed.push_back(tick);
    if (from.sample > to.sample) std::ranges::reverse(passed);
    return passed;
}

/// Calls `visit` for each point, preceded by the points that divide its move at the ends of an interval.
template <class Visit>
void forEachDivided(const std::vector<PathPoint>& points, const SourceStretch& stretch, const Visit& visit) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (i > 0)
            for (const std::int64_t tick : endsPassed(points[i - 1], points[i], stretch))
                visit(pointBetween(points[i - 1], points[i], tick));
        visit(points[i]);
    }
}

} // namespace

bool hasMoment(const PathPoint& point) noexcept {
    return point.source != 0 && point.sample >= 0;
}

Moment momentOf(const PathPoint& point) noexcept {
    return hasMoment(point) ? Moment{point.source, point.sample} : Moment{};
}

Moment momentAt(const PathPoint& from, const PathPoint& to, double share) noexcept {
    const bool led = hasMoment(from) && hasMoment(to) && from.source == to.source && to.kind != MoveKind::rapid;
    if (!led) return momentOf(share < 0.5 ? from : to);
    return {from.source,
            std::llround(glm::mix(static_cast<double>(from.sample), static_cast<double>(to.sample), share))};
}

bool leadsThrough(const Moment& from, const Moment& to, const SourceStretch& stretch) noexcept {
    if (to.source == 0) return false;
    if (stretch.contains(to)) return true;
    const auto [low, high] = std::minmax(from.tick, to.tick);
    return from.source == to.source && to.source == stretch.source && stretch.first < high && low < stretch.last;
}

std::vector<PathPoint> dividedAt(const std::vector<PathPoint>& points, const SourceStretch& stretch) {
    std::vector<PathPoint> divided;
    divided.reserve(points.size() + 2);
    forEachDivided(points, stretch, [&](const PathPoint& point) { divided.push_back(point); });
    return divided;
}

std::vector<std::vector<PathPoint>> pointsOf(const Path& path, const SourceStretch& stretch) {
    std::vector<std::vector<PathPoint>> chains;
    bool goesOn = false; // anything between two intervals is in neither
    forEachDivided(path.points, stretch, [&](const PathPoint& point) {
        const bool within = hasMoment(point) && stretch.contains(momentOf(point));
        if (within && !goesOn) chains.emplace_back();
        if (within) chains.back().push_back(point);
        goesOn = within;
    });
    return chains;
}

} // namespace burin
