// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/passes/tip_raster.h"

#include "core/base/parallel.h"
#include "core/passes/workpiece_heights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace burin {
namespace {

constexpr double sameHeight = 0.002; // mm: what lowestFeasibleHeight finds of a level face, within twice its tolerance

/// Borders of what is blocked, between places with room (> 0) and without: marching squares, with the blocked side to
/// the left. Where two blocked corners of a square face each other they are taken as joined.
class Borders {
public:
    /// @param room columns x rows values; beyond them there is room
    Borders(const std::vector<double>& room, int columns, int rows, double beyond)
        : room_(room), columns_(columns), rows_(rows), beyond_(beyond) {}

    /// Rings in squares from the first place.
    std::vector<PlanRing> rings() {
        for (int row = -1; row < rows_; ++row)
            for (int column = -1; column < columns_; ++column) cross(column, row);
        std::vector<PlanRing> rings;
        while (!next_.empty()) {
            PlanRing& ring = rings.emplace_back();
            const std::int64_t first = next_.begin()->first;
            std::int64_t edge = first;
            do {
                ring.push_back(placeOn(edge));
                const auto step = next_.find(edge);
                edge = step->second;
                next_.erase(step);
            } while (edge != first);
        }
        return rings;
    }

private:
    double at(int column, int row) const noexcept {
        if (column < 0 || row < 0 || column >= columns_ || row >= rows_) return beyond_;
        return room_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                     static_cast<std::size_t>(column)];
    }
    /// An edge from a place to the next one along x, or along y.
    std::int64_t edgeOf(int column, int row, bool upwards) const noexcept {
        return ((row + 1) * static_cast<std::int64_t>(columns_ + 2) + column + 1) * 2 + (upwards ? 1 : 0);
    }
    glm::dvec2 placeOn(std::int64_t edge) const noexcept {
        const bool upwards = edge % 2 == 1;
        const int column = static_cast<int>(edge / 2 % (columns_ + 2)) - 1;
        const int row = static_cast<int>(edge / 2 / (columns_ + 2)) - 1;
        const double here = at(column, row), there = upwards ? at(column, row + 1) : at(column + 1, row);
        const double share = here / (here - there);
        return glm::dvec2(column, row) + (upwards ? glm::dvec2(0.0, share) : glm::dvec2(share, 0.0));
    }
    void cross(int column, int row) {
        const std::array<double, 4> corners{at(column, row), at(column + 1, row), at(column + 1, row + 1),
                                            at(column, row + 1)};
        const std::array<std::int64_t, 4> edges{edgeOf(column, row, false), edgeOf(column + 1, row, true),
                                                edgeOf(column, row + 1, false), edgeOf(column, row, true)};
        for (std::size_t i = 0; i < 4; ++i) {
            if (!(corners[i] <= 0.0 && corners[(i + 1) % 4] > 0.0)) continue; // from here on there is room
            std::size_t last = (i + 1) % 4;
            while (corners[(last + 1) % 4] > 0.0) last = (last + 1) % 4;
            next_.emplace(edges[i], edges[last]);
        }
    }

    const std::vector<double>& room_;
    int columns_, rows_;
    double beyond_;
    std::unordered_map<std::int64_t, std::int64_t> next_;
};

} // namespace

TipRaster::TipRaster(const ClearanceField& field, const PlanBounds& bounds, double edge, double keep, double top,
                     double bottom, const Progress& progress)
    : field_(field)
    , edge_(edge)
    , keep_(keep)
    , bottom_(bottom)
    , low_(bounds.low)
    , columns_(static_cast<int>(std::ceil((bounds.high.x - bounds.low.x) / edge)) + 1)
    , rows_(static_cast<int>(std::ceil((bounds.high.y - bounds.low.y) / edge)) + 1)
    , reached_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_),
               std::numeric_limits<double>::infinity()) {
    parallelFor(0, rows_, [&](int row) {
        if (progress.cancelled()) return;
        for (int column = 0; column < columns_; ++column) {
            const glm::dvec2 place = placeOf(column, row);
            reached_[indexOf(column, row)] = lowestFeasibleHeight(field_, place.x, place.y, keep_, top, bottom_);
        }
    });
}

/// Where the part holds the tool up from above a height, how near the part is at that height says where its wall is;
/// under an overhang that is no measure, and the border is in the middle of a square.
std::vector<double> TipRaster::roomAt(double height) const {
    std::vector<double> room(reached_.size());
    parallelFor(0, rows_, [&](int row) {
        for (int column = 0; column < columns_; ++column) {
            const glm::dvec2 place = placeOf(column, row);
            const double spare = field_.at({place.x, place.y, height}).clearance - keep_;
            const std::size_t i = indexOf(column, row);
            const bool blocked = reached_[i] > height + sameHeight;
            room[i] = blocked ? -std::clamp(std::abs(spare), 1e-6, edge_) : std::clamp(spare, 1e-6, edge_);
        }
    });
    return room;
}

PlanRegion TipRaster::blockedAt(double height) const {
    const std::vector<double> room = roomAt(height);
    PlanRegion region;
    region.rings = Borders(room, columns_, rows_, edge_).rings();
    for (PlanRing& ring : region.rings)
        for (glm::dvec2& place : ring) place = low_ + edge_ * place;
    return region;
}

std::vector<double> TipRaster::levelFaces(double area) const {
    std::vector<double> sorted;
    for (const double height : reached_)
        if (std::isfinite(height) && height > bottom_ + sameHeight) sorted.push_back(height);
    std::ranges::sort(sorted, std::greater<>());
    std::vector<double> faces;
    const auto enough = static_cast<std::size_t>(std::max(4.0, area / (edge_ * edge_)));
    for (std::size_t first = 0; first < sorted.size();) {
        std::size_t end = first;
        while (end < sorted.size() && sorted[first] - sorted[end] <= sameHeight) ++end;
        if (end - first >= enough) faces.push_back(sorted[first]);
        first = end;
    }
    return faces;
}

} // namespace burin
