// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/height_map.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

constexpr double squaresPerRadius = 12.0;
constexpr double largestCount = 4096.0; // squares along a side of the stock

double widestOf(std::span<const RevolvedPiece> pieces) noexcept {
    double widest = 0.0;
    for (const RevolvedPiece& piece : pieces) widest = std::max(widest, piece.widestRadius());
    return widest;
}

double edgeOf(const Box& stock, std::span<const RevolvedPiece> flutes) {
    const glm::dvec3 size = stock.size();
    return std::max({widestOf(flutes) / squaresPerRadius, size.x / largestCount, size.y / largestCount, 0.02});
}

} // namespace

HeightMap::HeightMap(const Box& stock, std::span<const RevolvedPiece> pieces, std::size_t fluteCount,
                     const HollowSpace& hollow)
    : stock_(stock)
    , pieces_(pieces.begin(), pieces.end())
    , fluteCount_(fluteCount)
    , hollow_(hollow)
    , edge_(edgeOf(stock, pieces.first(fluteCount)))
    , countX_(std::max(0L, static_cast<long>(std::ceil(stock.size().x / edge_))))
    , countY_(std::max(0L, static_cast<long>(std::ceil(stock.size().y / edge_))))
    , heights_(static_cast<std::size_t>(countX_ * countY_), stock.high.z) {}

void HeightMap::include(const HeightMap& before) {
    constexpr double rounding = 1e-6; // squares
    const auto touched = [&](long square, int axis, long count) {
        const double low = stock_.low[axis] + static_cast<double>(square) * edge_ - before.stock_.low[axis];
        return Range{std::max(0L, static_cast<long>(std::floor(low / before.edge_ + rounding))),
                     std::min(count, static_cast<long>(std::ceil((low + edge_) / before.edge_ - rounding))) - 1};
    };
    for (long j = 0; j < countY_; ++j) {
        const Range rows = touched(j, 1, before.countY_);
        for (long i = 0; i < countX_; ++i) {
            const Range columns = touched(i, 0, before.countX_);
            double highest = stock_.low.z - 1e3;
            for (long row = rows.first; row <= rows.last; ++row)
                for (long column = columns.first; column <= columns.last; ++column)
                    highest = std::max(highest, before.height(column, row));
            height(i, j) = std::min(height(i, j), highest);
        }
    }
}

HeightMap::Range HeightMap::range(double centre, double radius, int axis) const {
    const double low = (centre - radius - stock_.low[axis]) / edge_,
                 high = (centre + radius - stock_.low[axis]) / edge_;
    const long count = axis == 0 ? countX_ : countY_;
    // Clamped before the conversion: a tip may be far away.
    return {static_cast<long>(std::clamp(std::floor(low), 0.0, static_cast<double>(count))),
            static_cast<long>(std::clamp(std::floor(high), -1.0, static_cast<double>(count - 1)))};
}

void HeightMap::cut(const glm::dvec3& from, const glm::dvec3& to) {
    const double length = glm::distance(from, to);
    const auto steps = static_cast<long>(std::max(1.0, std::ceil(length / edge_)));
    for (long i = 0; i <= steps; ++i) cutAt(from + (static_cast<double>(i) / static_cast<double>(steps)) * (to - from));
}

void HeightMap::cut(const Arc& arc) {
    const ArcTurn turn = turnOf(arc);
    const double length =
        std::hypot(std::max(turn.startRadius, turn.endRadius) * turn.sweep, arc.to[arc.axis] - arc.from[arc.axis]);
    const auto steps = static_cast<long>(std::max(1.0, std::ceil(length / edge_)));
    for (long i = 0; i <= steps; ++i) cutAt(placeOn(arc, turn, static_cast<double>(i) / static_cast<double>(steps)));
}

void HeightMap::cutAt(const glm::dvec3& tip) {
    const std::span<const RevolvedPiece> flutes = std::span(pieces_).first(fluteCount_);
    const double widest = widestOf(flutes);
    const auto [left, right] = range(tip.x, widest, 0);
    const auto [front, back] = range(tip.y, widest, 1);
    for (long j = front; j <= back; ++j) {
        const double y = stock_.low.y + static_cast<double>(j) * edge_ - tip.y;
        const double farY = std::max(std::abs(y), std::abs(y + edge_)), nearY = std::max({y, -y - edge_, 0.0});
        for (long i = left; i <= right; ++i) {
            double& now = height(i, j);
            if (tip.z >= now || tip.z + flutes.back().top < now) continue;
            const double x = stock_.low.x + static_cast<double>(i) * edge_ - tip.x;
            const double farX = std::max(std::abs(x), std::abs(x + edge_));
            const double far = std::hypot(farX, farY);
            const bool inHollow =
                hollow_.radius > 0.0 && std::hypot(std::max({x, -x - edge_, 0.0}), nearY) < hollow_.radius;
            const double lowest = inHollow ? hollow_.height : 0.0;
            // From the top down: above a piece nothing is cut, so material there stays.
            for (std::size_t piece = flutes.size(); piece-- > 0;) {
                const auto heights = heightsAt(flutes[piece], far);
                if (heights && heights->high > lowest && tip.z + heights->high >= now)
                    now = std::min(now, tip.z + std::max(heights->low, lowest));
            }
        }
    }
}

double HeightMap::heightAt(const glm::dvec3& place) const {
    const double i = std::floor((place.x - stock_.low.x) / edge_), j = std::floor((place.y - stock_.low.y) / edge_);
    if (!(i >= 0.0 && j >= 0.0 && i < static_cast<double>(countX_) && j < static_cast<double>(countY_)))
        return stock_.low.z - 1e3;
    return height(static_cast<long>(i), static_cast<long>(j));
}

double HeightMap::freeHeight(const glm::dvec3& from, const glm::dvec3& to) const {
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    const auto steps = static_cast<long>(std::max(1.0, std::ceil(length / edge_)));
    double height = stock_.low.z - 1e3;
    for (long i = 0; i <= steps; ++i) {
        const glm::dvec3 place = glm::mix(from, to, static_cast<double>(i) / static_cast<double>(steps));
        height = restingHeight(place.x, place.y, pieces_, height, 0.5 * edge_);
    }
    return height;
}

double HeightMap::risenHeight(const glm::dvec3& tip) const {
    const std::span<const RevolvedPiece> flutes = std::span(pieces_).first(fluteCount_);
    RevolvedPiece column;
    column.bottomRadius = column.topRadius = widestOf(flutes);
    column.top = stock_.high.z - stock_.low.z;
    const double length = flutes.back().top;
    return std::max(tip.z, restingHeight(tip.x, tip.y, std::span(&column, 1), tip.z + length) - length);
}

double HeightMap::restingHeight(double x, double y, std::span<const RevolvedPiece> pieces, double floor, double slack,
                                double radius) const {
    double resting = floor;
    for (const RevolvedPiece& piece : pieces) {
        if (stock_.high.z - piece.bottom <= resting) continue; // above everything
        const auto [left, right] = range(x, piece.widestRadius() + slack, 0);
        const auto [front, back] = range(y, piece.widestRadius() + slack, 1);
        for (long j = front; j <= back; ++j) {
            const double low = stock_.low.y + static_cast<double>(j) * edge_ - y;
            const double nearY = std::max({low, -low - edge_, 0.0});
            for (long i = left; i <= right; ++i) {
                if (height(i, j) - piece.bottom <= resting) continue;
                const double side = stock_.low.x + static_cast<double>(i) * edge_ - x;
                const double nearX = std::max({side, -side - edge_, 0.0});
                const double distance = std::max(0.0, std::hypot(nearX, nearY) - slack);
                if (distance > radius) continue;
                if (const auto heights = heightsAt(piece, distance))
                    resting = std::max(resting, height(i, j) - heights->low);
            }
        }
    }
    return resting;
}

} // namespace burin
