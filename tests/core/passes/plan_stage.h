// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/passes/milling_plan.h"
#include "tests/core/passes/planned_fields.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace burin::test {

inline const LyingCapsule mouse(3.0, 27.5, 27.5, 5.0); // 110 x 55 x 32.5 mm, ball of 6 mm
inline const Box mouseStock = {mouse.box().low - glm::dvec3(5.0), mouse.box().high + glm::dvec3(5.0)};

/// Stock on a raster that shares nothing with the planner's: another spacing, another origin, plain loops.
class StockRaster {
public:
    static constexpr double width = 0.37;
    explicit StockRaster(const Box& stock) : stock_(stock) {
        columns_ = static_cast<int>(stock.size().x / width);
        rows_ = static_cast<int>(stock.size().y / width);
        heights_.assign(static_cast<std::size_t>(columns_ * rows_), stock.high.z);
    }
    /// Highest stock whose column lies within `radius` of the tip's axis, above the tip.
    double highestAround(const glm::dvec3& tip, double radius) const {
        double highest = stock_.low.z;
        each(tip, radius, [&](double height, double) { highest = std::max(highest, height); });
        return highest - tip.z;
    }
    /// Stock higher than the flutes is undercut; its top is kept.
    void cutBall(const glm::dvec3& tip, double radius, double flutes = 1e9) {
        const_cast<StockRaster*>(this)->eachChanging(tip, radius, [&](double& height, double square) {
            if (height <= tip.z + flutes)
                height = std::min(height, tip.z + radius - std::sqrt(radius * radius - square));
        });
    }
    /// Greatest height of the stock that is above `allowed(x, y)`.
    double highestAbove(const std::function<double(double, double)>& allowed, double inset) const {
        double most = -1e9;
        for (int row = 0; row < rows_; ++row)
            for (int column = 0; column < columns_; ++column) {
                const double x = stock_.low.x + (column + 0.5) * width, y = stock_.low.y + (row + 0.5) * width;
                if (x < stock_.low.x + inset || y < stock_.low.y + inset || x > stock_.high.x - inset ||
                    y > stock_.high.y - inset)
                    continue;
                most = std::max(most, heights_[static_cast<std::size_t>(row * columns_ + column)] - allowed(x, y));
            }
        return most;
    }

private:
    void each(const glm::dvec3& tip, double radius, const std::function<void(double, double)>& visit) const {
        const_cast<StockRaster*>(this)->eachChanging(tip, radius, [&](double& h, double square) { visit(h, square); });
    }
    void eachChanging(const glm::dvec3& tip, double radius, const std::function<void(double&, double)>& visit) {
        const int reach = static_cast<int>(radius / width) + 2;
        const int middleColumn = static_cast<int>(std::floor((tip.x - stock_.low.x) / width));
        const int middleRow = static_cast<int>(std::floor((tip.y - stock_.low.y) / width));
        for (int row = middleRow - reach; row <= middleRow + reach; ++row)
            for (int column = middleColumn - reach; column <= middleColumn + reach; ++column) {
                if (row < 0 || column < 0 || row >= rows_ || column >= columns_) continue;
                const double dx = stock_.low.x + (column + 0.5) * width - tip.x;
                const double dy = stock_.low.y + (row + 0.5) * width - tip.y;
                if (dx * dx + dy * dy < radius * radius)
                    visit(heights_[static_cast<std::size_t>(row * columns_ + column)], dx * dx + dy * dy);
            }
    }
    Box stock_;
    int columns_ = 0, rows_ = 0;
    std::vector<double> heights_;
};

/// Visits points of the tip's path, at most 0.2 mm apart; the part holds the tip up at `resting`.
inline void follow(const std::vector<IntentPoint>& points, const std::function<void(const glm::dvec3&)>& visit) {
    for (std::size_t i = 1; i < points.size(); ++i) {
        const glm::dvec3 from = points[i - 1].tip, to = points[i].tip;
        const int steps = static_cast<int>(std::ceil(glm::distance(from, to) / 0.2));
        for (int k = 1; k <= steps; ++k) visit(glm::mix(from, to, static_cast<double>(k) / steps));
    }
}

struct Plunges {
    double deepest = 0.0; ///< mm of stock that the middle of the ball met during a descent
    double lowest = 1e9;  ///< mm, tip
};

/// The stock that a ball of 6 mm meets from above while it is held up at a height.
inline Plunges deepestPlunge(const std::vector<IntentPoint>& points, const Box& stockBox, double resting) {
    StockRaster stock(stockBox);
    Plunges plunges;
    glm::dvec3 before = points.front().tip;
    follow(points, [&](const glm::dvec3& hand) {
        const glm::dvec3 tip(hand.x, hand.y, std::max(hand.z, resting));
        if (tip.z < before.z - 1e-9) plunges.deepest = std::max(plunges.deepest, stock.highestAround(tip, 0.4));
        stock.cutBall(tip, 3.0);
        plunges.lowest = std::min(plunges.lowest, tip.z);
        before = tip;
    });
    return plunges;
}

inline RoughingRequest roughingRequest(double bottom = 0.0) {
    RoughingRequest request;
    request.bottom = bottom;
    return request;
}

inline FinishingRequest finishingRequest(const Box& part) {
    FinishingRequest request;
    request.part = part;
    request.floor = part.low.z;
    return request;
}

inline double lengthOverPart(const std::vector<IntentPoint>& points) {
    const Box& box = mouse.box();
    double length = 0.0;
    follow(points, [&](const glm::dvec3& tip) {
        if (tip.z < mouseStock.high.z && tip.x > box.low.x + 3.0 && tip.x < box.high.x - 3.0 &&
            mouse.restingTip(tip.x, tip.y) > 0.0 && std::abs(tip.y) < box.high.y - 3.0)
            length += 0.2;
    });
    return length;
}

} // namespace burin::test
