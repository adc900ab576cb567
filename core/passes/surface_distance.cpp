// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/passes/surface_distance.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <queue>
#include <utility>

namespace burin {
namespace {

constexpr double farAway = std::numeric_limits<double>::infinity();
/// Neighbours in order: each forms a triangle with the next one.
constexpr std::array<std::pair<int, int>, 8> turns{
    {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

class FastMarch {
public:
    FastMarch(const SurfaceRaster& surface, const std::function<double(std::size_t, std::size_t)>& length)
        : surface_(surface), distance_(surface.on.size(), farAway), fixed_(surface.on.size(), 0) {
        measure(length);
    }

    std::vector<double> fromBorder(double beginning) {
        for (int row = 0; row < surface_.rows; ++row)
            for (int column = 0; column < surface_.columns; ++column)
                if (surface_.on[surface_.indexOf(column, row)] && isBorder(column, row))
                    reach(surface_.indexOf(column, row), beginning);
        return spread();
    }
    std::vector<double> from(const std::vector<double>& beginnings) {
        for (std::size_t i = 0; i < beginnings.size(); ++i)
            if (surface_.on[i]) reach(i, beginnings[i]);
        return spread();
    }

private:
    using Open = std::pair<double, std::size_t>;

    std::vector<double> spread() {
        while (!open_.empty()) {
            const auto [distance, place] = open_.top();
            open_.pop();
            if (fixed_[place]) continue;
            fixed_[place] = 1;
            const auto columns = static_cast<std::size_t>(surface_.columns);
            const int column = static_cast<int>(place % columns), row = static_cast<int>(place / columns);
            for (std::size_t turn = 0; turn < turns.size(); ++turn) {
                const auto& [right, up] = turns[turn];
                if (const auto next = at(column + right, row + up); next && !fixed_[*next])
                    reach(*next, nearestBy(column + right, row + up, opposite(turn)));
            }
        }
        for (double& distance : distance_)
            if (distance == farAway) distance = 0.0; // outside the surface
        return std::move(distance_);
    }

    std::optional<std::size_t> at(int column, int row) const {
        if (column < 0 || row < 0 || column >= surface_.columns || row >= surface_.rows) return {};
        const std::size_t place = surface_.indexOf(column, row);
        return surface_.on[place] ? std::optional(place) : std::nullopt;
    }
    bool isBorder(int column, int row) const {
        return !at(column + 1, row) || !at(column - 1, row) || !at(column, row + 1) || !at(column, row - 1);
    }
    void reach(std::size_t place, double distance) {
        if (!(distance < distance_[place])) return;
        distance_[place] = distance;
        open_.emplace(distance, place);
    }

    static std::size_t opposite(std::size_t turn) { return (turn + 4) % turns.size(); }

    /// Measures each side once: from a point in the first four directions.
    void measure(const std::function<double(std::size_t, std::size_t)>& length) {
        sides_.resize(4 * surface_.on.size());
        parallelFor(0, surface_.rows, [&](int row) {
            for (int column = 0; column < surface_.columns; ++column)
                for (std::size_t turn = 0; turn < 4; ++turn) {
                    const auto here = at(column, row), there = at(column + turns[turn].first, row + turns[turn].second);
                    if (here && there) sides_[4 * *here + turn] = length(*here, *there);
                }
        });
    }
    /// The length of a side from a point in a direction; both ends belong to the surface.
    double side(int column, int row, std::size_t turn) const {
        if (turn < 4) return sides_[4 * surface_.indexOf(column, row) + turn];
        return sides_[4 * surface_.indexOf(column + turns[turn].first, row + turns[turn].second) + opposite(turn)];
    }

    /// The shortest distance of a point along the side to a neighbour that has just been fixed, or through the two
    /// triangles at this side: those without it were asked when their own corners were fixed. @param turn from the
    /// point to the neighbour
    double nearestBy(int column, int row, std::size_t turn) const {
        const double first = side(column, row, turn);
        const auto neighbour = [&](std::size_t to) {
            return std::pair(column + turns[to].first, row + turns[to].second);
        };
        const auto [oneColumn, oneRow] = neighbour(turn);
        const std::size_t one = surface_.indexOf(oneColumn, oneRow);
        double least = distance_[one] + first;
        for (const std::size_t beside : {(turn + 1) % turns.size(), (turn + turns.size() - 1) % turns.size()}) {
            const auto [otherColumn, otherRow] = neighbour(beside);
            const auto other = fixedAt(otherColumn, otherRow);
            if (!other) continue;
            const double second = side(column, row, beside);
            const double between = side(oneColumn, oneRow, turnTo(otherColumn - oneColumn, otherRow - oneRow));
            least = std::min(least, across(one, *other, between, first, second));
        }
        return least;
    }
    static std::size_t turnTo(int right, int up) {
        const auto found = std::ranges::find(turns, std::pair(right, up));
        return static_cast<std::size_t>(found - turns.begin());
    }
    std::optional<std::size_t> fixedAt(int column, int row) const {
        const auto place = at(column, row);
        return place && fixed_[*place] ? place : std::nullopt;
    }
    /// The distance by a straight front that passes both corners of a triangle, if it comes through the side between
    /// them.
    double across(std::size_t one, std::size_t other, double between, double first, double second) const {
        const double slope = (distance_[other] - distance_[one]) / between;
        const double x = (first * first + between * between - second * second) / (2.0 * between);
        const double y = std::sqrt(std::max(0.0, first * first - x * x));
        if (!(std::abs(slope) < 1.0) || y == 0.0) return farAway;
        const double rise = std::sqrt(1.0 - slope * slope);
        const double through = x - slope / rise * y;
        if (through < 0.0 || through > between) return farAway;
        return distance_[one] + slope * x + rise * y;
    }

    const SurfaceRaster& surface_;
    std::vector<double> sides_; ///< by point and direction
    std::vector<double> distance_;
    std::vector<char> fixed_;
    std::priority_queue<Open, std::vector<Open>, std::greater<>> open_;
};

} // namespace

std::vector<double> distancesFromBorder(const SurfaceRaster& surface,
                                        const std::function<double(std::size_t, std::size_t)>& length,
                                        double beginning) {
    return FastMarch(surface, length).fromBorder(beginning);
}

std::vector<double> distancesFrom(const SurfaceRaster& surface,
                                  const std::function<double(std::size_t, std::size_t)>& length,
                                  const std::vector<double>& beginnings) {
    return FastMarch(surface, length).from(beginnings);
}

} // namespace burin
