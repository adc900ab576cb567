// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/run_volume.h"

#include <cstdint>
#include <vector>

namespace burin {

/// Measures the thickness of the stock along a direction: exactly to where its runs end, scanline by scanline, or a
/// brick at a time where all scanlines of the brick hold stock. Thread-safe.
class LeftOver {
public:
    /// Examines every brick, in parallel. Keeps a reference to the workpiece, which must not change.
    explicit LeftOver(const RunVolume& workpiece);

    /// Thickness from a point along a unit direction to the end of the stock (air or the border of the grid), mm.
    /// Protected material is passed and not counted. Starts an eighth of a voxel out and ends after `longest` mm. 0 if
    /// the point is bare.
    double along(const glm::dvec3& place, const glm::dvec3& direction, double longest) const noexcept;

private:
    /// Interval, in run units, in which all 64 lines of a brick hold stock.
    struct Common {
        std::int32_t from = 0, to = 0;
    };
    Common commonOf(LineIndex corner) const;

    const RunVolume& workpiece_;
    const Grid& grid_;
    std::int32_t bricksU_ = 0;
    std::vector<Common> common_; ///< by v, then by u
};

} // namespace burin
