// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cutting/cutting_force.h"
#include "core/path/apply.h"
#include "core/volume/runs/run_volume.h"

#include <vector>

namespace burin {

/// An interval of a move and the material that the tool removed on it.
struct MetInterval {
    std::size_t move = 0;                ///< index of the point at which the move ends
    double end = 0.0;                    ///< fraction of the move at which it ends
    double length = 0.0;                 ///< mm
    glm::dvec3 from{0.0}, to{0.0};       ///< mm
    std::vector<MaterialVolume> removed; ///< as in CutResult, only materials of which something was removed
    double reported = 0.0;               ///< mm³
    glm::dvec3 centroid{0.0};            ///< mm, of the material reported last
    Engagement engagement;               ///< at the last position that was cut

    CutResult cut() const; ///< in the form that the force model needs; stored compactly, as a path has many intervals
};

/// Resolution at which a path is cut again.
enum class RecordGrain {
    fine,  ///< in steps of a quarter of a voxel, so that the reported values show little of the voxel grid
    coarse ///< each interval in one step: many times faster, its volume exact but off by a layer of voxels at its ends
};
/// Cuts a path out of a stock again, in intervals of `sampling` mm at most; rapids cut nothing.
/// Errors: volumeOutOfMemory, cancelled.
Result<std::vector<MetInterval>> recordEngagement(const std::vector<PathPoint>& points, const Tool& tool,
                                                  RunVolume& stock, double sampling, Progress& progress,
                                                  RecordGrain grain = RecordGrain::fine);

} // namespace burin
