// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/run_volume.h"

namespace burin {

// Union, intersection and difference of two objects on the same grid (Chen & Yang 2004, section 4.3), run by run, run
// ends kept to 1/256 voxel. Where both hold material the first one's property counts. Brick by brick, in parallel:
// bricks of which one operand is air or solid are copied or left out whole.

// ---- A new volume, with the first one's property list; the operands stay as they are. Most of the time goes into
// reserving the new volume's memory (RunVolume::defaultReserve).
// Errors: argumentInvalid (the grids differ), outOfMemory.

/// What belongs to one or the other. Properties of `b` that `a` has not (by id) are added to the list, whether runs of
/// `b` hold them or not; further error: argumentInvalid when the list does not take one of them (PropertyList::add: it
/// is full, or has as many machinable ones as it may), with its id as the place.
Result<RunVolume> unionOf(const VolumeSnapshot& a, const VolumeSnapshot& b);
/// What belongs to both.
Result<RunVolume> intersectionOf(const VolumeSnapshot& a, const VolumeSnapshot& b);
/// What belongs to `a` alone.
Result<RunVolume> differenceOf(const VolumeSnapshot& a, const VolumeSnapshot& b);

// ---- Into a volume that stands, in its own memory; what it held is replaced. `a` or `b` may be a snapshot of it, so
// that `uniteInto(v, v.snapshot(), b)` adds `b` to `v` and bricks that stay as they are cost nothing. Writer's thread
// of `result`. Errors: argumentInvalid (the grids differ, a property that `result` has not), outOfMemory,
// volumeOutOfMemory (some bricks of `result` are replaced then, others not: put a snapshot back).

Result<void> uniteInto(RunVolume& result, const VolumeSnapshot& a, const VolumeSnapshot& b);
Result<void> intersectInto(RunVolume& result, const VolumeSnapshot& a, const VolumeSnapshot& b);
Result<void> subtractInto(RunVolume& result, const VolumeSnapshot& a, const VolumeSnapshot& b);

} // namespace burin
