// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/box.h"

#include <cstdint>
#include <functional>
#include <unordered_map>
#include <vector>

namespace burin {

/// Finds routes of a tip at one height around obstacles: the shortest over the points of a square grid and their eight
/// neighbours (A*: P. Hart, N. Nilsson, B. Raphael, A formal basis for the heuristic determination of minimum cost
/// paths, 1968), then drawn taut. Points are checked only when the search reaches them.
class WayRound {
public:
    /// Whether a tip may be at a point, and whether it may go along a straight line. The height is known to the
    /// callbacks.
    using IsFree = std::function<bool(const glm::dvec2&)>;
    using IsClear = std::function<bool(const glm::dvec2& from, const glm::dvec2& to)>;

    /// @param area where routes may lead, mm @param step mm between points of the grid
    WayRound(const Box& area, double step);

    /// The corners of a route behind `from`, ending in `to`; empty if there is no route, or only one longer than
    /// `longest` mm. Every straight segment of it is clear.
    std::vector<glm::dvec2> find(const glm::dvec2& from, const glm::dvec2& to, double longest, const IsFree& isFree,
                                 const IsClear& isClear) const;

private:
    struct Cell {
        std::int32_t x = 0, y = 0;
        bool operator==(const Cell&) const = default;
    };
    struct CellHash {
        std::size_t operator()(const Cell& cell) const noexcept {
            return std::hash<std::int64_t>()(std::int64_t{cell.y} * 0x9E3779B1 + cell.x);
        }
    };
    using Parents = std::unordered_map<Cell, Cell, CellHash>;

    bool search(const Cell& start, const Cell& goal, double longest, const IsFree& isFree, Parents& parents) const;
    Cell cellOf(const glm::dvec2& place) const noexcept;
    glm::dvec2 placeOf(const Cell& cell) const noexcept;

    Box area_;
    double step_;
    std::int32_t countX_, countY_;
};

} // namespace burin
