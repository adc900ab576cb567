// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/geometry/placement.h"
#include "core/volume/runs/run_volume.h"

namespace burin {

struct MovedVolume {
    RunVolume volume;
    /// mm by which a face may lie beside the moved one: 0 of a placement along axes, else half the diagonal of a
    /// voxel's face, as across its runs a volume is known to the scanline.
    double greatestDisplacement = 0.0;
};

/// A volume as it lies in another frame: turned about and moved with what it is part of, in voxels of the same size,
/// with the same property list. Its runs lie along the axis that comes nearest to theirs. A placement along axes takes
/// each run to one run: nothing is lost, and the way back gives the same volume. Else each new scanline has what it
/// meets of the old runs, seen as boxes one voxel wide, exact to 1/256 voxel.
/// Cost: grows with the scanlines of both and what they meet; parallel.
/// Errors: volumeTooLarge, outOfMemory, cancelled.
Result<MovedVolume> moved(const VolumeSnapshot& volume, const Placement& placement, Progress& progress);

} // namespace burin
