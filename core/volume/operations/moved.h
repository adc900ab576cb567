// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/geometry/placement.h"
#include "core/volume/runs/run_volume.h"

namespace burin {

struct MovedVolume {
    RunVolume volume;
    /// Largest deviation of a face from its exact position, mm: 0 for a placement along axes, otherwise half the
    /// diagonal of a voxel's face, because across its runs a volume is resolved only to the scanline.
    double greatestDisplacement = 0.0;
};

/// A volume in another frame: rotated and translated together with what it is part of, in voxels of the same size, with
/// the same property list. Its runs lie along the axis nearest to theirs. A placement along axes takes each run to one
/// run: nothing is lost, and the inverse gives the same volume. Otherwise each new scanline gets its intersections with
/// the old runs, which are taken as boxes one voxel wide, exact to 1/256 voxel.
/// Cost: grows with the scanlines of both and their intersections; parallel.
/// Errors: volumeTooLarge, outOfMemory, cancelled.
Result<MovedVolume> moved(const VolumeSnapshot& volume, const Placement& placement, Progress& progress);

} // namespace burin
