// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/cleared_heights.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace burin {
namespace {

constexpr double squaresPerRadius = 12.0;
constexpr double largestCount = 4096.0; // squares along a side of the stock

double radiusOf(const RevolvedPiece& piece) noexcept {
    return std::max(piece.bottomRadius, piece.topRadius);
}

/// Height of the piece's lower surface above the tip, at a distance from the axis; nothing beyond its radius.
std::optional<double> lowerHeight(const RevolvedPiece& piece, double distance) noexcept {
    const double floor = piece.bottomRadius - piece.cornerRadius;
    if (distance <= floor) return piece.bottom;
    if (distance <= piece.bottomRadius) {
        const double across = distance - floor;
        return piece.bottom + piece.cornerRadius -
               std::sqrt(std::max(0.0, piece.cornerRadius * piece.cornerRadius - across * across));
    }
    if (distance <= piece.topRadius)
        return piece.bottom +
               (piece.top - piece.bottom) * (distance - piece.bottomRadius) / (piece.topRadius - piece.bottomRadius);
    return std::nullopt;
}

double edgeOf(const Box& stock, const RevolvedPiece& flutes) {
    const glm::dvec3 size = stock.size();
    return std::max({radiusOf(flutes) / squaresPerRadius, size.x / largestCount, size.y / largestCount, 0.02});
}

} // namespace

ClearedHeights::ClearedHeights(const Box& stock, std::span<const RevolvedPiece> pieces)
    : stock_(stock)
    , pieces_(pieces.begin(), pieces.end())
    , edge_(edgeOf(stock, pieces_.front()))
    , countX_(std::max(0L, static_cast<long>(std::ceil(stock.size().x / edge_))))
    , countY_(std::max(0L, static_cast<long>(std::ceil(stock.size().y / edge_))))
    , heights_(static_cast<std::size_t>(countX_ * countY_), stock.high.z) {}

ClearedHeights::Range ClearedHeights::range(double centre, double radius, int axis) const {
    const double low = (centre - radius - stock_.low[axis]) / edge_,
                 high = (centre + radius - stock_.low[axis]) / edge_;
    const long count = axis == 0 ? countX_ : countY_;
    // Clamped before the change of type: a tip may be far away.
    return {static_cast<long>(std::clamp(std::floor(low), 0.0, static_cast<double>(count))),
            static_cast<long>(std::clamp(std::floor(high), -1.0, static_cast<double>(count - 1)))};
}

void ClearedHeights::cut(const glm::dvec3& from, const glm::dvec3& to) {
    const double length = glm::distance(from, to);
    const auto steps = static_cast<long>(std::max(1.0, std::ceil(length / edge_)));
    for (long i = 0; i <= steps; ++i) cutAt(from + (static_cast<double>(i) / static_cast<double>(steps)) * (to - from));
}

void ClearedHeights::cutAt(const glm::dvec3& tip) {
    const RevolvedPiece& flutes = pieces_.front();
    const auto [left, right] = range(tip.x, radiusOf(flutes), 0);
    const auto [front, back] = range(tip.y, radiusOf(flutes), 1);
    for (long j = front; j <= back; ++j) {
        const double y = stock_.low.y + static_cast<double>(j) * edge_ - tip.y;
        const double farY = std::max(std::abs(y), std::abs(y + edge_));
        for (long i = left; i <= right; ++i) {
            double& now = height(i, j);
            // Above the flutes nothing is cut, so material there would stay.
            if (tip.z >= now || tip.z + flutes.top < now) continue;
            const double x = stock_.low.x + static_cast<double>(i) * edge_ - tip.x;
            const double farX = std::max(std::abs(x), std::abs(x + edge_));
            const auto lower = lowerHeight(flutes, std::hypot(farX, farY));
            if (lower && tip.z + *lower < now) now = tip.z + *lower;
        }
    }
}

double ClearedHeights::restingHeight(double x, double y, std::span<const RevolvedPiece> pieces, double floor) const {
    double resting = floor;
    for (const RevolvedPiece& piece : pieces) {
        if (stock_.high.z - piece.bottom <= resting) continue; // above everything
        const auto [left, right] = range(x, radiusOf(piece), 0);
        const auto [front, back] = range(y, radiusOf(piece), 1);
        for (long j = front; j <= back; ++j) {
            const double low = stock_.low.y + static_cast<double>(j) * edge_ - y;
            const double nearY = std::max({low, -low - edge_, 0.0});
            for (long i = left; i <= right; ++i) {
                if (height(i, j) - piece.bottom <= resting) continue;
                const double side = stock_.low.x + static_cast<double>(i) * edge_ - x;
                const double nearX = std::max({side, -side - edge_, 0.0});
                if (const auto lower = lowerHeight(piece, std::hypot(nearX, nearY)))
                    resting = std::max(resting, height(i, j) - *lower);
            }
        }
    }
    return resting;
}

} // namespace burin
