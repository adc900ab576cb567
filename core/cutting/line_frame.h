// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/box.h"
#include "core/geometry/pose.h"
#include "core/volume/runs/grid.h"

#include <algorithm>
#include <cmath>

namespace burin {

/// Transforms a vector of the setup frame into the frame of a grid's lines: x along u, y along v, z along the runs. The
/// axes are exchanged cyclically, so that the frame stays right-handed.
inline glm::dvec3 inLineFrame(const Grid& grid, const glm::dvec3& v) noexcept {
    return {v[grid.axisOfU()], v[grid.axisOfV()], v[grid.axisOfRuns()]};
}
inline ToolPose inLineFrame(const Grid& grid, const ToolPose& pose) noexcept {
    return {inLineFrame(grid, pose.tip), inLineFrame(grid, pose.axis)};
}
inline Box inLineFrame(const Grid& grid, const Box& box) noexcept {
    return {inLineFrame(grid, box.low), inLineFrame(grid, box.high)};
}
/// The inverse transformation.
inline glm::dvec3 inSetupFrame(const Grid& grid, const glm::dvec3& v) noexcept {
    glm::dvec3 result;
    result[grid.axisOfU()] = v.x;
    result[grid.axisOfV()] = v.y;
    result[grid.axisOfRuns()] = v.z;
    return result;
}

} // namespace burin
