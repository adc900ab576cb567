// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/volume/runs/run_volume.h"

#include <vector>

namespace burin {

/// How changing the run axis of a volume changed its shape, taken as boxes one voxel wide around each scanline.
struct TurnLoss {
    std::vector<double> changed;       ///< mm³ by property index: after minus before
    double greatestDisplacement = 0.0; ///< of a face, in voxels: at most 1/2
};

struct TurnedVolume {
    RunVolume volume;
    TurnLoss loss;
};

/// The same volume with its runs along another axis, on the same grid and with the same property list.
///
/// Each voxel keeps the property of its centre: a volume of whole voxels is converted without loss in both directions.
/// Run ends within a voxel move, along the old axis, to the nearest voxel face (by at most 1/2 voxel). Along the new
/// axis an end lies where the straight line between the ends on the two neighbouring old scanlines passes, so that a
/// plane remains a plane to 1/128 voxel; where these ends have no counterpart on the neighbour, lie more than eight
/// voxels apart or both lie on voxel faces, the new end lies on the voxel face between the two scanlines.
///
/// Cost: linear in the runs of both volumes, plus making the new one; parallel. Errors: cancelled, outOfMemory.
Result<TurnedVolume> turned(const VolumeSnapshot& volume, RunAxis axis, Progress& progress);

} // namespace burin
