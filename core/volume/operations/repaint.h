// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/run_volume.h"

namespace burin {

/// Gives all that is not air between two planes one property. Along the runs the planes are kept to 1/256 voxel; across
/// them a scanline belongs where its centre lies. Parallel. Writer's thread, not for the haptic loop.
/// @param axis 0, 1, 2 for x, y, z: that the planes stand across @param from, to mm, setup frame; may be infinite
/// Errors: argumentInvalid (the volume has no such property), outOfMemory, volumeOutOfMemory (some bricks are changed
/// then, others not; it may be called again).
Result<void> repaint(RunVolume& volume, PropertyIndex property, int axis, double from, double to);

} // namespace burin
