// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/run_volume.h"

namespace burin {

// Union, intersection and difference of two objects on the same grid (Chen & Yang 2004, section 4.3), run by run, run
// ends kept to 1/256 voxel. The operands stay as they are; the result is a new volume with the first one's property
// list. Where both hold material the first one's property counts.
// Errors: argumentInvalid (the grids differ), outOfMemory, volumeOutOfMemory.

/// What belongs to one or the other. Properties of `b` that `a` has not (by id) are added to the list; further error:
/// argumentInvalid when the list is full.
Result<RunVolume> unionOf(const VolumeSnapshot& a, const VolumeSnapshot& b);
/// What belongs to both.
Result<RunVolume> intersectionOf(const VolumeSnapshot& a, const VolumeSnapshot& b);
/// What belongs to `a` alone.
Result<RunVolume> differenceOf(const VolumeSnapshot& a, const VolumeSnapshot& b);

} // namespace burin
