// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/grid.h"

#include <array>
#include <cstdint>

namespace burin {

/// The material that cuts removed, counted during removal.
struct RemovedUnits {
    std::array<std::uint64_t, 256> byProperty{}; ///< run units
    std::uint64_t total = 0;                     ///< run units
    double momentU = 0.0, momentV = 0.0;         ///< run units times line
    double momentAlong = 0.0;                    ///< run units times run unit
    bool outOfMemory = false;                    ///< lines from there on are uncut
};

/// Returns the centroid of the removed material, which must not be empty: mm, setup frame.
inline glm::dvec3 centroidOf(const RemovedUnits& removed, const Grid& grid) noexcept {
    const double units = static_cast<double>(removed.total);
    glm::dvec3 centroid(0.0); // in voxels from the grid's low corner
    centroid[grid.axisOfU()] = removed.momentU / units + 0.5;
    centroid[grid.axisOfV()] = removed.momentV / units + 0.5;
    centroid[grid.axisOfRuns()] = removed.momentAlong / units / unitsPerVoxel;
    return grid.low() + centroid * grid.edge();
}

} // namespace burin
