// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/link_room.h"

#include "core/path/round_corner.h"
#include "core/path/way_round.h"

#include <algorithm>
#include <cmath>

namespace burin {

LinkRoom::LinkRoom(const Link& edit, const PartGuard& guard, const PathContext& context, double safeHeight)
    : approach_(edit.approach)
    , travel_(edit.travel)
    , rounding_(context.machine.rapids != RapidMode::independent ? edit.rounding : 0.0)
    , rapidsAreStraight_(context.machine.rapids != RapidMode::independent)
    , safeHeight_(safeHeight)
    , reach_(context.tool.cutter.diameter)
    , guard_(guard)
    , cleared_(context.stock, guard.pieces(), flutePieces(context.tool.cutter).size(), context.tool.cutter.hollow()) {
    if (context.cleared) cleared_.include(*context.cleared);
    area_ = context.stock;
    for (const ObstacleSolid& obstacle : context.obstacles)
        if (obstacle.on) area_.include(obstacle.surface->bounds());
    area_ = area_.grown(context.tool.cutter.diameter + edit.clearanceAbove);
    for (const ObstacleSolid& obstacle : context.obstacles)
        if (obstacle.on) obstacles_.emplace_back(PartGuard(*obstacle.surface, context.tool), obstacle.margin);
}

std::vector<glm::dvec3> LinkRoom::swing(const glm::dvec3& tip, const glm::dvec3& move, double required) const {
    const double level = std::hypot(move.x, move.y);
    if (!(rounding_ > 0.0) || level < 1e-6 || std::abs(move.z) > 0.1 * level) return {tip};
    const glm::dvec3 direction(move.x / level, move.y / level, 0.0);
    double radius = std::min(rounding_, safeHeight_ - tip.z);
    for (int halving = 0; halving < 4 && radius > 0.1; ++halving, radius *= 0.5) {
        std::vector<glm::dvec3> places = quarterUp(tip, direction, radius);
        if (mayCut(places, required) && isClearAbove(places.back(), safeHeight_)) return places;
    }
    return {tip};
}

bool LinkRoom::mayCut(const std::vector<glm::dvec3>& places, double required) const {
    const auto keeps = [&](const PartGuard& guard, double distance) {
        const double own = guard.clearance(places.front(), distance + 1.0).clearance;
        for (std::size_t i = 1; i < places.size(); ++i)
            if (!guard.isClear(places[i - 1], places[i], std::min(distance, own) - touchTolerance, defaultSampling))
                return false;
        return true;
    };
    return std::ranges::all_of(places, [&](const glm::dvec3& place) { return cleared_.shankIsFree(place); }) &&
           keeps(guard_, required) && std::ranges::all_of(obstacles_, [&](const auto& obstacle) {
               return keeps(obstacle.first, obstacle.second);
           });
}

std::vector<glm::dvec3> LinkRoom::rounded(const std::vector<glm::dvec3>& way) const {
    std::vector<glm::dvec3> smooth;
    for (std::size_t i = 0; i < way.size(); ++i) {
        if (i == 0 || i + 1 == way.size()) {
            smooth.push_back(way[i]);
            continue;
        }
        const glm::dvec3 back = way[i - 1] - way[i], on = way[i + 1] - way[i];
        double leg = std::min({rounding_, 0.5 * glm::length(back), 0.5 * glm::length(on)});
        std::vector<glm::dvec3> arc{way[i]};
        for (int halving = 0; halving < 4; ++halving, leg *= 0.5) {
            const std::vector<glm::dvec3> wider = cornerArc(way[i], back, on, leg);
            if (!mayPass(wider)) continue;
            arc = wider;
            break;
        }
        smooth.insert(smooth.end(), arc.begin(), arc.end());
    }
    return smooth;
}

/// Whether rapids along these points stay above the remaining stock, and clear of part and obstacles.
bool LinkRoom::mayPass(const std::vector<glm::dvec3>& places) const {
    for (std::size_t i = 1; i < places.size(); ++i) {
        const double height = std::min(places[i - 1].z, places[i].z);
        if (cleared_.freeHeight(places[i - 1], places[i]) + approach_ > height) return false;
        if (!isClear(places[i - 1], places[i])) return false;
    }
    return true;
}

/// Whether a move is clear of the part, and of obstacles by their margins.
bool LinkRoom::isClear(const glm::dvec3& from, const glm::dvec3& to) const {
    return guard_.isClear(from, to, 0.0, defaultSampling) && std::ranges::all_of(obstacles_, [&](const auto& obstacle) {
               return obstacle.first.isClear(from, to, obstacle.second, defaultSampling);
           });
}

/// The same between a stroke and a point above it: the stroke's own clearance does not prevent leaving it.
bool LinkRoom::isClearAbove(const glm::dvec3& tip, double height) const {
    const auto passes = [&](const PartGuard& guard, double distance) {
        const double required = std::min(distance, guard.clearance(tip, distance + 1.0).clearance) - touchTolerance;
        return guard.isClear(tip, {tip.x, tip.y, height}, required, defaultSampling);
    };
    return passes(guard_, 0.0) && std::ranges::all_of(obstacles_, [&](const auto& obstacle) {
               return passes(obstacle.first, obstacle.second);
           });
}

/// Whether the tool may go straight across at a height, above the remaining stock, clear of part and obstacles.
bool LinkRoom::isClearAcross(const glm::dvec2& from, const glm::dvec2& to, double height) const {
    const glm::dvec3 start(from, height), end(to, height);
    return cleared_.freeHeight(start, end) + approach_ <= height && isClear(start, end);
}

/// Whether a tip is above the remaining stock, and farther than `spare` from the part and from obstacles' margins, mm.
bool LinkRoom::isFree(const glm::dvec3& tip, double spare) const {
    return cleared_.freeHeight(tip.x, tip.y) + approach_ <= tip.z && guard_.clearance(tip, spare).clearance >= spare &&
           std::ranges::all_of(obstacles_, [&](const auto& obstacle) {
               const double distance = obstacle.second + spare;
               return obstacle.first.clearance(tip, distance).clearance >= distance;
           });
}

LinkRoute LinkRoom::wayTo(const glm::dvec3& from, const glm::dvec3& to) const {
    if (travel_ == Link::Travel::safe) return {safeHeight_, {}};
    if (!rapidsAreStraight_ && from.x != to.x && from.y != to.y) return {safeHeight_, {}};
    const double height = std::max({cleared_.freeHeight(from, to), from.z, to.z}) + approach_;
    if (height >= safeHeight_) return around(from, to);
    const bool clear = isClearAbove(from, height) && isClearAbove(to, height) &&
                       isClear({from.x, from.y, height}, {to.x, to.y, height});
    return clear ? LinkRoute{height, {}} : around(from, to);
}

/// The shortest route, at one of several heights, around obstacles; else over everything.
LinkRoute LinkRoom::around(const glm::dvec3& from, const glm::dvec3& to) const {
    constexpr int levels = 4;
    LinkRoute best{safeHeight_, {}};
    if (travel_ != Link::Travel::around || !rapidsAreStraight_) return best;
    const double across = glm::distance(glm::dvec2(from), glm::dvec2(to));
    double shortest = 2.0 * safeHeight_ - from.z - to.z + across;
    const double lowest =
        std::max({cleared_.freeHeight(from.x, from.y), cleared_.freeHeight(to.x, to.y), from.z, to.z}) + approach_;
    const glm::dvec3 size = area_.size();
    const double step = std::max(0.5 * reach_, std::max(size.x, size.y) / 64.0);
    const WayRound search(area_, step);
    for (int level = 0; level < levels; ++level) {
        const double height = lowest + (safeHeight_ - lowest) * level / levels;
        const double longest = shortest - (2.0 * height - from.z - to.z);
        if (height >= safeHeight_ || longest <= across) continue;
        if (!isClearAbove(from, height) || !isClearAbove(to, height)) continue;
        const auto isFreeAt = [&](const glm::dvec2& place) { return isFree({place, height}, 0.25 * step); };
        const auto isSeen = [&](const glm::dvec2& a, const glm::dvec2& b) { return isClearAcross(a, b, height); };
        std::vector<glm::dvec2> corners = search.find(from, to, longest, isFreeAt, isSeen);
        if (corners.empty()) continue;
        double length = 2.0 * height - from.z - to.z;
        glm::dvec2 at(from);
        for (const glm::dvec2& corner : corners) {
            length += glm::distance(at, corner);
            at = corner;
        }
        if (length >= shortest) continue;
        corners.pop_back(); // the one over the entry
        shortest = length;
        best = {height, std::move(corners)};
    }
    return best;
}

bool LinkRoom::canJoin(const glm::dvec3& end, const glm::dvec3& start, double required) const {
    const double length = glm::distance(end, start);
    if (length > reach_ || !guard_.isClear(end, start, required, defaultSampling)) return false;
    for (const auto& [obstacle, margin] : obstacles_)
        if (!obstacle.isClear(end, start, 0.0, defaultSampling)) return false;
    constexpr double sampling = 0.25; // mm
    const int steps = std::max(1, static_cast<int>(length / sampling) + 1);
    for (int i = 0; i <= steps; ++i) {
        const glm::dvec3 tip = end + (static_cast<double>(i) / steps) * (start - end);
        if (!cleared_.shankIsFree(tip)) return false;
    }
    return true;
}

} // namespace burin
