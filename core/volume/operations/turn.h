// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/volume/runs/run_volume.h"

#include <vector>

namespace burin {

/// What turning a volume to another run axis did to its shape, seen as boxes one voxel wide around each scanline.
struct TurnLoss {
    std::vector<double> changed;       ///< mm³ by property index: after less before
    double greatestDisplacement = 0.0; ///< of a face, voxels: at most 1/2
};

struct TurnedVolume {
    RunVolume volume;
    TurnLoss loss;
};

/// The same volume with its runs along another axis, in the same grid and with the same property list.
///
/// Each voxel keeps the property of its centre: a volume of whole voxels is turned without loss, there and back. Of
/// run ends within a voxel the old axis keeps the nearest voxel face (1/2 voxel at most). Along the new axis an end
/// lies where the straight line between the ends in the two neighbouring old scanlines passes, so that a plane stays
/// one to 1/128 voxel; where these ends have no partner in the neighbour, lie more than eight voxels apart or both on
/// voxel faces, it lies on the voxel face between the two.
///
/// Cost: linear in the runs of both volumes, plus making the new one; parallel. Errors: cancelled, outOfMemory.
Result<TurnedVolume> turned(const VolumeSnapshot& volume, RunAxis axis, Progress& progress);

} // namespace burin
