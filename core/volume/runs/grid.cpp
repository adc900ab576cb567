// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/runs/grid.h"

#include "core/base/numbers.h"

#include <algorithm>
#include <cmath>

namespace burin {

Result<Grid> Grid::make(const glm::dvec3& low, double edge, const glm::ivec3& count, RunAxis axis) {
    if (!std::isfinite(edge) || edge <= 0.0)
        return Error{ErrorCode::argumentInvalid, "voxel edge", formatShortest(edge), "a finite length above 0 mm"};
    for (int i = 0; i < 3; ++i) {
        if (!std::isfinite(low[i]))
            return Error{ErrorCode::argumentInvalid, "low corner of the grid", formatShortest(low[i]),
                         "a finite length"};
        if (count[i] < 1 || count[i] > maximumVoxelsPerAxis)
            return Error{ErrorCode::volumeTooLarge,
                         std::to_string(count.x) + " x " + std::to_string(count.y) + " x " + std::to_string(count.z) +
                             " voxels",
                         "1 to " + std::to_string(maximumVoxelsPerAxis) + " voxels on each axis",
                         {}};
    }
    Grid grid;
    grid.low_ = low;
    grid.edge_ = edge;
    grid.count_ = count;
    grid.axis_ = axis;
    return grid;
}

RunPosition Grid::toRunPosition(double along) const noexcept {
    const double units = (along - low_[axisOfRuns()]) / edge_ * unitsPerVoxel;
    if (!(units > 0.0)) return 0; // also for NaN
    return static_cast<RunPosition>(std::min(units, static_cast<double>(lineEnd())) + 0.5);
}

namespace {

std::int32_t component(VoxelIndex voxel, int axis) noexcept {
    return axis == 0 ? voxel.i : axis == 1 ? voxel.j : voxel.k;
}

} // namespace

LineIndex Grid::lineOf(VoxelIndex voxel) const noexcept {
    return {component(voxel, axisOfU()), component(voxel, axisOfV())};
}

std::int32_t Grid::alongOf(VoxelIndex voxel) const noexcept {
    return component(voxel, axisOfRuns());
}

VoxelIndex Grid::voxel(LineIndex line, std::int32_t along) const noexcept {
    switch (axis_) {
    case RunAxis::x:
        return {along, line.u, line.v};
    case RunAxis::y:
        return {line.v, along, line.u};
    case RunAxis::z:
        break;
    }
    return {line.u, line.v, along};
}

bool Grid::contains(VoxelIndex voxel) const noexcept {
    return voxel.i >= 0 && voxel.j >= 0 && voxel.k >= 0 && voxel.i < count_.x && voxel.j < count_.y &&
           voxel.k < count_.z;
}

} // namespace burin
