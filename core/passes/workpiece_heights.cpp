// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/passes/workpiece_heights.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin {

namespace {
constexpr double tolerance = 1e-3;    // mm, of a height
constexpr double shortestStep = 0.02; // mm: along a wall, where the clearance hardly changes
constexpr double largestRaster = 0.5; // mm
constexpr double mostCells = 4e6;
constexpr double shankMargin = 1.0; // mm between standing stock and the end of the flutes, at most a fifth of them
} // namespace

double lowestFeasibleHeight(const ClearanceField& field, double x, double y, double allowance, double top,
                            double bottom) noexcept {
    const auto spare = [&](double z) { return field.at({x, y, z}).clearance - allowance; };
    double high = top; // known to be feasible
    double room = spare(high);
    if (!(room >= 0.0)) return std::numeric_limits<double>::infinity();
    double low = high;
    while (true) {
        if (high <= bottom) return bottom;
        low = std::max(bottom, high - std::max(room, shortestStep));
        const double next = spare(low);
        if (!(next >= 0.0)) break;
        high = low;
        room = next;
    }
    while (high - low > tolerance) {
        const double middle = 0.5 * (low + high);
        (spare(middle) >= 0.0 ? high : low) = middle;
    }
    return high;
}

double usableFlutes(const Cutter& cutter) noexcept {
    return cutter.fluteLength - std::min(shankMargin, 0.2 * cutter.fluteLength);
}

double lateralMargin(const Cutter& cutter) noexcept {
    return std::min(0.5, cutter.radius() / 6.0);
}

double trembleMargin(const Cutter& cutter) noexcept {
    return std::min(0.1, cutter.radius() / 30.0);
}

WorkpieceHeights::WorkpieceHeights(const Box& stock, const Cutter& cutter, double coarseness)
    : stock_(stock), cutter_(cutter), flutes_(flutePieces(cutter)) {
    const glm::dvec3 size = stock.size();
    cell_ =
        std::max(coarseness * std::min(largestRaster, cutter.radius() / 6.0), std::sqrt(size.x * size.y / mostCells));
    columns_ = std::max(1, static_cast<int>(std::ceil(size.x / cell_)));
    rows_ = std::max(1, static_cast<int>(std::ceil(size.y / cell_)));
    heights_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), stock.high.z);
    reliefs_.push_back({usableFlutes(cutter), 0.5 * cutter.shankDiameter + lateralMargin(cutter)});
    double height = cutter.stickOut;
    for (const HolderSegment& segment : cutter.holder) {
        reliefs_.push_back(
            {height, 0.5 * std::max(segment.lowerDiameter, segment.upperDiameter) + lateralMargin(cutter)});
        height += segment.length;
    }
}

template <class Visit>
void WorkpieceHeights::visitDisc(double x, double y, double radius, Visit&& visit) const noexcept {
    const double u = (x - stock_.low.x) / cell_ - 0.5; // in cells, with centres at whole numbers
    const double v = (y - stock_.low.y) / cell_ - 0.5;
    const double reach = radius / cell_;
    if (u + reach < 0.0 || v + reach < 0.0 || u - reach > columns_ - 1.0 || v - reach > rows_ - 1.0) return;
    const int first = std::max(0, static_cast<int>(std::ceil(v - reach)));
    const int last = std::min(rows_ - 1, static_cast<int>(std::floor(v + reach)));
    for (int row = first; row <= last; ++row) {
        const double across = row - v;
        const double half = std::sqrt(std::max(0.0, reach * reach - across * across));
        const int begin = std::max(0, static_cast<int>(std::ceil(u - half)));
        const int end = std::min(columns_ - 1, static_cast<int>(std::floor(u + half)));
        for (int column = begin; column <= end; ++column) {
            const std::size_t index =
                static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
            visit(index, cell_ * std::sqrt((column - u) * (column - u) + across * across));
        }
    }
}

double WorkpieceHeights::riseAt(double distance) const noexcept {
    double rise = cutter_.fluteLength;
    for (const RevolvedPiece& piece : flutes_)
        if (const std::optional<HeightRange> heights = heightsAt(piece, distance)) rise = std::min(rise, heights->low);
    return rise;
}

double StandingStock::highestIn(const glm::dvec2& from, const glm::dvec2& to) const noexcept {
    const glm::dvec2 first = (from - low) / edge, last = (to - low) / edge;
    double highest = WorkpieceHeights::nothing;
    for (int row = std::max(0, static_cast<int>(std::floor(first.y))); row < std::min<double>(rows, last.y); ++row)
        for (int column = std::max(0, static_cast<int>(std::floor(first.x)));
             column < std::min<double>(columns, last.x); ++column)
            highest = std::max(highest, heights[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                                                static_cast<std::size_t>(column)]);
    return highest;
}

void WorkpieceHeights::lowerTo(const StandingStock& standing) noexcept {
    if (standing.heights.empty()) return;
    for (int row = 0; row < rows_; ++row)
        for (int column = 0; column < columns_; ++column) {
            const glm::dvec2 from = glm::dvec2(stock_.low) + cell_ * glm::dvec2(column, row);
            double& height = heights_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                                      static_cast<std::size_t>(column)];
            height = std::min(height, standing.highestIn(from, from + glm::dvec2(cell_)));
        }
}

void WorkpieceHeights::cut(const glm::dvec3& tip) noexcept {
    const HollowSpace hollow = cutter_.hollow(); // a core may stand in it
    const double hollowRadius = hollow.radius > 0.0 ? hollow.radius + trembleMargin(cutter_) : 0.0;
    const double flutes = usableFlutes(cutter_);
    visitDisc(tip.x, tip.y, cutter_.radius() - trembleMargin(cutter_), [&](std::size_t index, double distance) {
        const double lowest = distance < hollowRadius ? hollow.height : 0.0;
        if (lowest >= flutes) return;
        // Stock that is higher than the flutes reach is only undercut; its top stays.
        if (heights_[index] <= tip.z + flutes)
            heights_[index] = std::min(heights_[index], tip.z + std::max(riseAt(distance), lowest));
    });
}

void WorkpieceHeights::cut(const glm::dvec3& from, const glm::dvec3& to) noexcept {
    const int steps = std::max(1, static_cast<int>(std::ceil(glm::length(to - from) / cell_)));
    for (int i = 0; i <= steps; ++i) cut(glm::mix(from, to, static_cast<double>(i) / steps));
}

double WorkpieceHeights::highestWithin(double x, double y, double radius) const noexcept {
    double highest = nothing;
    visitDisc(x, y, radius, [&](std::size_t index, double) { highest = std::max(highest, heights_[index]); });
    return highest;
}

double WorkpieceHeights::freeTip(double x, double y, double inset) const noexcept {
    double lowest = nothing;
    visitDisc(x, y, cutter_.radius() - inset, [&](std::size_t index, double distance) {
        lowest = std::max(lowest, heights_[index] - riseAt(distance));
    });
    return lowest;
}

double WorkpieceHeights::safeHeight(const glm::dvec3& tip, double further) const noexcept {
    double safe = tip.z;
    for (const Relief& relief : reliefs_)
        if (stock_.high.z - relief.height > safe) // otherwise even untouched stock would not reach it
            safe = std::max(safe, highestWithin(tip.x, tip.y, relief.radius + further) - relief.height);
    return safe;
}

} // namespace burin
