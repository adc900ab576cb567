// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/passes/surface_distance.h"

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
        : surface_(surface), length_(length), distance_(surface.on.size(), farAway), fixed_(surface.on.size(), 0) {}

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
            for (const auto& [right, up] : turns)
                if (const auto next = at(column + right, row + up); next && !fixed_[*next])
                    reach(*next, nearest(column + right, row + up));
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

    /// The shortest distance through the triangles around a point whose other corners are fixed, or along one of their
    /// sides.
    double nearest(int column, int row) const {
        const std::size_t place = surface_.indexOf(column, row);
        double least = farAway;
        for (std::size_t i = 0; i < turns.size(); ++i) {
            const auto one = fixedAt(column + turns[i].first, row + turns[i].second);
            if (!one) continue;
            const double first = length_(*one, place);
            least = std::min(least, distance_[*one] + first);
            const auto& turn = turns[(i + 1) % turns.size()];
            if (const auto other = fixedAt(column + turn.first, row + turn.second))
                least = std::min(least, across(*one, *other, place, first));
        }
        return least;
    }
    std::optional<std::size_t> fixedAt(int column, int row) const {
        const auto place = at(column, row);
        return place && fixed_[*place] ? place : std::nullopt;
    }
    /// The distance by a straight front that passes both corners of a triangle, if it comes through the side between
    /// them.
    double across(std::size_t one, std::size_t other, std::size_t place, double first) const {
        const double side = length_(one, other), second = length_(other, place);
        const double slope = (distance_[other] - distance_[one]) / side;
        const double x = (first * first + side * side - second * second) / (2.0 * side);
        const double y = std::sqrt(std::max(0.0, first * first - x * x));
        if (!(std::abs(slope) < 1.0) || y == 0.0) return farAway;
        const double rise = std::sqrt(1.0 - slope * slope);
        const double through = x - slope / rise * y;
        if (through < 0.0 || through > side) return farAway;
        return distance_[one] + slope * x + rise * y;
    }

    const SurfaceRaster& surface_;
    const std::function<double(std::size_t, std::size_t)>& length_;
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
