// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/field/tool_field.h"
#include "core/geometry/plan_region.h"

#include <vector>

namespace burin {

/// Where the tool may be at a height, seen from above: the heights down to which it can come straight down, on a
/// raster.
class TipRaster {
public:
    /// Keeps a reference to the field. Cancellable; points that were not examined then count as unreachable.
    /// @param keep clearance from the part, mm @param edge edge of a square, mm @param top, bottom heights of tips, mm
    TipRaster(const ClearanceField& field, const PlanBounds& bounds, double edge, double keep, double top,
              double bottom, const Progress& progress);

    /// The region from which the part keeps the tool at a height, mm; along walls its border is as exact as the field.
    /// Nothing is blocked outside the raster.
    PlanRegion blockedAt(double height) const;
    /// The heights of level faces larger than `area`, mm², on which the tool can stand; in descending order.
    std::vector<double> levelFaces(double area) const;

private:
    std::size_t indexOf(int column, int row) const noexcept {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
    }
    glm::dvec2 placeOf(int column, int row) const noexcept { return low_ + edge_ * glm::dvec2(column, row); }
    std::vector<double> roomAt(double height) const;

    const ClearanceField& field_;
    double edge_, keep_, bottom_;
    glm::dvec2 low_;
    int columns_, rows_; ///< of points
    std::vector<double> reached_;
};

} // namespace burin
