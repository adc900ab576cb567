// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/passes/tip_raster.h"

#include "core/base/parallel.h"
#include "core/passes/raster_borders.h"
#include "core/passes/workpiece_heights.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin {
namespace {

// mm: spread of the heights that lowestFeasibleHeight finds on a level face, within twice its tolerance
constexpr double sameHeight = 0.002;

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

/// Where the part stops the tool above a height, the distance of the part at that height gives the position of its
/// wall. Under an overhang that distance is meaningless, and the border is in the middle of a square.
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
    region.rings = bordersOf(room, columns_, rows_, edge_);
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
