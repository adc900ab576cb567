// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cutting/cutting_force.h"
#include "core/path/apply.h"
#include "core/volume/runs/run_volume.h"

#include <vector>

namespace burin {

/// A stretch of a move and what the tool met on it.
struct MetStretch {
    std::size_t move = 0;                ///< index of the point that the move ends in
    double end = 0.0;                    ///< share of the move at which it ends
    double length = 0.0;                 ///< mm
    glm::dvec3 from{0.0}, to{0.0};       ///< mm
    std::vector<MaterialVolume> removed; ///< as in CutResult, those that lost something
    double reported = 0.0;               ///< mm³
    glm::dvec3 centroid{0.0};            ///< mm, of what was reported last
    Engagement engagement;               ///< at the last place that was cut

    CutResult cut() const; ///< as the force wants it; kept in short, as a path has many stretches
};

/// How finely a path is cut again.
enum class RecordGrain {
    fine,  ///< in steps of a quarter of a voxel, so that what is reported has little of the voxels' grain
    coarse ///< each interval at once: many times faster, its volume exact but off by a layer of voxels at its ends
};
/// Cuts a path out of a stock again, stretch by stretch of `sampling` mm at most; rapids cut nothing.
/// Errors: volumeOutOfMemory, cancelled.
Result<std::vector<MetStretch>> recordEngagement(const std::vector<PathPoint>& points, const Tool& tool,
                                                 RunVolume& stock, double sampling, Progress& progress,
                                                 RecordGrain grain = RecordGrain::fine);

} // namespace burin
