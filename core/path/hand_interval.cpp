// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/hand_interval.h"

#include "core/geometry/arc.h"
#include "core/path/path_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace burin {

namespace {

PathPoint pointBetween(const PathPoint& from, const PathPoint& to, std::int64_t tick) {
    const double share = static_cast<double>(tick - from.sample) / static_cast<double>(to.sample - from.sample);
    PathPoint point = to;
    point.sample = tick;
    point.pose.tip = glm::mix(from.pose.tip, to.pose.tip, share);
    if (from.pose.axis != to.pose.axis) point.pose.axis = glm::normalize(glm::mix(from.pose.axis, to.pose.axis, share));
    if (to.arc) {
        const Arc arc{from.pose.tip, to.pose.tip, to.arc->centre, to.arc->axis, to.arc->clockwise};
        point.pose.tip = placeOn(arc, turnOf(arc), share);
    }
    return point;
}

/// Ends of an interval that a move passes between its own ends, in the order in which it passes them.
std::vector<std::int64_t> endsPassed(const PathPoint& from, const PathPoint& to, const SourceInterval& interval) {
    std::vector<std::int64_t> passed;
    if (!hasMoment(from) || !hasMoment(to) || from.source != to.source || interval.source != from.source) return passed;
    if (to.kind == MoveKind::rapid) return passed; // across a part that the path leaves out
    const auto [low, high] = std::minmax(from.sample, to.sample);
    for (const std::int64_t tick : {interval.first, interval.last})
        if (low < tick && tick < high && (passed.empty() || passed.back() != tick)) passed.push_back(tick);
    if (from.sample > to.sample) std::ranges::reverse(passed);
    return passed;
}

/// Calls `visit` for each point, preceded by the points that divide its move at the ends of an interval.
template <class Visit>
void forEachDivided(const std::vector<PathPoint>& points, const SourceInterval& interval, const Visit& visit) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (i > 0)
            for (const std::int64_t tick : endsPassed(points[i - 1], points[i], interval))
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

InsertPoint insertionAt(const std::vector<PathPoint>& points, std::size_t piece, double share) {
    const PathPoint &from = points[piece], &to = points[piece + 1];
    InsertPoint edit;
    edit.at = momentAt(from, to, share);
    const bool planned = hasMoment(from) && hasMoment(to) && from.source == to.source && from.source < 0;
    if (!planned || to.kind == MoveKind::rapid) return edit;
    edit.at = momentOf(from);
    edit.beyond = share * lengthOf(from.pose.tip, to);
    // Points that an edit inserted have the moment of the one before.
    for (std::size_t i = piece; i > 0 && momentOf(points[i - 1]) == edit.at; --i)
        edit.beyond += lengthOf(points[i - 1].pose.tip, points[i]);
    return edit;
}

bool leadsThrough(const Moment& from, const Moment& to, const SourceInterval& interval) noexcept {
    if (to.source == 0) return false;
    if (interval.contains(to)) return true;
    const auto [low, high] = std::minmax(from.tick, to.tick);
    return from.source == to.source && to.source == interval.source && interval.first < high && low < interval.last;
}

std::vector<PathPoint> dividedAt(const std::vector<PathPoint>& points, const SourceInterval& interval) {
    std::vector<PathPoint> divided;
    divided.reserve(points.size() + 2);
    forEachDivided(points, interval, [&](const PathPoint& point) { divided.push_back(point); });
    return divided;
}

std::vector<std::vector<PathPoint>> pointsOf(const Path& path, const SourceInterval& interval) {
    std::vector<std::vector<PathPoint>> chains;
    bool goesOn = false; // anything between two intervals is in neither
    forEachDivided(path.points, interval, [&](const PathPoint& point) {
        const bool within = hasMoment(point) && interval.contains(momentOf(point));
        if (within && !goesOn) chains.emplace_back();
        if (within) chains.back().push_back(point);
        goesOn = within;
    });
    return chains;
}

std::optional<PathPoint> pointAt(const Path& path, const Moment& moment) {
    if (moment.source == 0) return std::nullopt;
    const std::vector<std::vector<PathPoint>> chains = pointsOf(path, {moment.source, moment.tick, moment.tick});
    return chains.empty() ? std::nullopt : std::optional(chains.front().front());
}

Moment momentNear(const Path& path, const glm::dvec3& place) {
    Moment nearest;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < path.points.size(); ++i) {
        const PathPoint &from = path.points[i - 1], &to = path.points[i];
        if (to.kind == MoveKind::rapid) continue;
        const PlaceOnPath near = nearestOnMove(from, to, place);
        if (near.distance >= least) continue;
        least = near.distance;
        nearest = momentAt(from, to, near.share);
    }
    return nearest;
}

std::optional<glm::dvec3> placeAt(const Path& path, const Moment& moment, const std::optional<glm::dvec3>& tip) {
    const auto madeThen = [&](const PathPoint& point) { return hasMoment(point) && point.source == moment.source; };
    for (std::size_t i = 1; tip && i < path.points.size(); ++i) {
        const PathPoint &from = path.points[i - 1], &to = path.points[i];
        if (!madeThen(from) || !madeThen(to) || to.kind == MoveKind::rapid) continue;
        const auto [low, high] = std::minmax(from.sample, to.sample);
        if (low <= moment.tick && moment.tick <= high) return nearestOnMove(from, to, *tip).place;
    }
    const std::optional<PathPoint> point = pointAt(path, moment);
    return point ? std::optional(point->pose.tip) : std::nullopt;
}

} // namespace burin
