// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/field/tool_field.h"
#include "core/geometry/plan_region.h"

#include <vector>

namespace burin {

/// Where the tool may be at a height, from above: the heights down to which it can come straight down, on a raster.
class TipRaster {
public:
    /// Keeps a reference to the field. Cancellable: what is not looked at yet can't be reached then.
    /// @param keep mm, clearance from the part. @param edge mm, of a square. @param top, bottom mm, of tips
    TipRaster(const ClearanceField& field, const PlanBounds& bounds, double edge, double keep, double top,
              double bottom, const Progress& progress);

    /// Where the part keeps the tool from being at a height, mm; its border along walls is as exact as the field.
    /// Beyond the raster nothing does.
    PlanRegion blockedAt(double height) const;
    /// Heights at which the tool can stand on level faces of more than an area, mm²; falling.
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
    int columns_, rows_; ///< of places
    std::vector<double> reached_;
};

} // namespace burin
