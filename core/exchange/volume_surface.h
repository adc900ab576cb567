// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/geometry/triangle_mesh.h"
#include "core/volume/runs/run_volume.h"

#include <vector>

namespace burin {

/// The closed surface of everything that is not air, with the material under each triangle.
struct VolumeSurface {
    TriangleMesh mesh;                    ///< mm, setup frame; oriented outwards
    std::vector<PropertyIndex> materials; ///< per triangle
};
/// At full resolution, as it is displayed. Errors: cancelled, outOfMemory.
Result<VolumeSurface> surfaceOf(const VolumeSnapshot& volume, Progress& progress);
/// The same with fewer triangles. @param tolerance mm by which simplification may move the surface; 0: not at all
Result<VolumeSurface> surfaceOf(const VolumeSnapshot& volume, double tolerance, Progress& progress);

} // namespace burin
