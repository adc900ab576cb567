// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/way_round.h"

#include <algorithm>
#include <cmath>
#include <queue>

namespace burin {

WayRound::WayRound(const Box& area, double step)
    : area_(area)
    , step_(step)
    , countX_(static_cast<std::int32_t>(area.size().x / step) + 1)
    , countY_(static_cast<std::int32_t>(area.size().y / step) + 1) {}

WayRound::Cell WayRound::cellOf(const glm::dvec2& place) const noexcept {
    const glm::dvec2 at = glm::round((place - glm::dvec2(area_.low)) / step_);
    return {std::clamp(static_cast<std::int32_t>(at.x), 0, countX_ - 1),
            std::clamp(static_cast<std::int32_t>(at.y), 0, countY_ - 1)};
}

glm::dvec2 WayRound::placeOf(const Cell& cell) const noexcept {
    return glm::dvec2(area_.low) + step_ * glm::dvec2(cell.x, cell.y);
}

bool WayRound::search(const Cell& start, const Cell& goal, double longest, const IsFree& isFree,
                      Parents& parents) const {
    struct Open {
        double least; ///< mm, lower bound of the length from start to goal through this point
        double cost;  ///< mm from the start
        Cell cell;
        bool operator<(const Open& other) const noexcept { return least > other.least; }
    };
    const auto left = [&](const Cell& cell) { return step_ * std::hypot(cell.x - goal.x, cell.y - goal.y); };
    std::priority_queue<Open> open;
    std::unordered_map<Cell, double, CellHash> costs{{start, 0.0}};
    open.push({left(start), 0.0, start});
    while (!open.empty()) {
        const Open top = open.top();
        open.pop();
        if (top.cell == goal) return true;
        if (top.least > longest) return false;
        if (top.cost > costs[top.cell]) continue; // a shorter route was found since
        for (std::int32_t dy = -1; dy <= 1; ++dy)
            for (std::int32_t dx = -1; dx <= 1; ++dx) {
                const Cell next{top.cell.x + dx, top.cell.y + dy};
                if ((dx == 0 && dy == 0) || next.x < 0 || next.y < 0 || next.x >= countX_ || next.y >= countY_)
                    continue;
                const double cost = top.cost + step_ * std::hypot(dx, dy);
                const auto [known, isNew] = costs.try_emplace(next, cost);
                if (!isNew && known->second <= cost) continue;
                if (isNew && !(next == goal) && !isFree(placeOf(next))) {
                    known->second = 0.0; // never improved: the search does not return to it
                    continue;
                }
                known->second = cost;
                parents[next] = top.cell;
                open.push({cost + left(next), cost, next});
            }
    }
    return false;
}

std::vector<glm::dvec2> WayRound::find(const glm::dvec2& from, const glm::dvec2& to, double longest,
                                       const IsFree& isFree, const IsClear& isClear) const {
    const Cell start = cellOf(from), goal = cellOf(to);
    Parents parents;
    if (!search(start, goal, longest + 4.0 * step_, isFree, parents)) return {};
    std::vector<glm::dvec2> places{to};
    for (Cell cell = goal; !(cell == start);) {
        places.push_back(placeOf(cell));
        cell = parents.at(cell);
    }
    places.push_back(placeOf(start));
    std::reverse(places.begin(), places.end());

    // Drawn taut: from each corner to the farthest point visible from it, found by bisection.
    std::vector<glm::dvec2> corners;
    glm::dvec2 at = from;
    double length = 0.0;
    for (std::size_t next = 0; next < places.size();) {
        if (!isClear(at, places[next])) return {};
        std::size_t seen = next, unseen = places.size();
        if (isClear(at, places.back())) seen = places.size() - 1;
        while (seen + 1 < unseen && seen + 1 < places.size()) {
            const std::size_t middle = seen + (unseen - seen) / 2;
            if (middle < places.size() && isClear(at, places[middle]))
                seen = middle;
            else
                unseen = middle;
        }
        length += glm::distance(at, places[seen]);
        at = places[seen];
        corners.push_back(at);
        next = seen + 1;
    }
    return length <= longest ? corners : std::vector<glm::dvec2>{};
}

} // namespace burin
