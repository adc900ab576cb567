// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/run_volume.h"

namespace burin {

// Union, intersection and difference of two objects on the same grid (Chen & Yang 2004, section 4.3), run by run, with
// run ends kept to 1/256 voxel. Where both hold material, the property of the first one is used. Brick by brick, in
// parallel: bricks of which one operand is air or solid are copied or skipped as a whole.

// ---- Functions that return a new volume with the property list of the first operand; the operands are unchanged. Most
// of the time is spent on reserving the new volume's memory (RunVolume::defaultReserve).
// Errors: argumentInvalid (the grids differ), outOfMemory.

/// What belongs to either of the two. Properties of `b` that `a` does not have (by id) are added to the list, whether
/// or not runs of `b` hold them; further error: argumentInvalid if one of them can't be added (PropertyList::add: the
/// list is full, or has the maximum number of machinable ones), with its id as the place.
Result<RunVolume> unionOf(const VolumeSnapshot& a, const VolumeSnapshot& b);
/// What belongs to both.
Result<RunVolume> intersectionOf(const VolumeSnapshot& a, const VolumeSnapshot& b);
/// What belongs to `a` alone.
Result<RunVolume> differenceOf(const VolumeSnapshot& a, const VolumeSnapshot& b);

// ---- Functions that write into an existing volume, in its own memory; its content is replaced. `a` or `b` may be a
// snapshot of it, so that `uniteInto(v, v.snapshot(), b)` adds `b` to `v`, and unchanged bricks cost nothing. Writer's
// thread of `result`. Errors: argumentInvalid (the grids differ, or `result` lacks a property), outOfMemory,
// volumeOutOfMemory (some bricks of `result` are then replaced and others not: restore a snapshot).

Result<void> uniteInto(RunVolume& result, const VolumeSnapshot& a, const VolumeSnapshot& b);
Result<void> intersectInto(RunVolume& result, const VolumeSnapshot& a, const VolumeSnapshot& b);
Result<void> subtractInto(RunVolume& result, const VolumeSnapshot& a, const VolumeSnapshot& b);

} // namespace burin
