// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/run_volume.h"

namespace burin {

/// Sets everything but air between two planes to one property. Along the runs the planes are resolved to 1/256 voxel;
/// across them a scanline counts if its centre lies between the planes. Parallel. Writer's thread, not for the haptic
/// loop.
/// @param axis  0, 1, 2 for x, y, z: normal of the planes  @param from, to  mm, setup frame; may be infinite
/// Errors: argumentInvalid (the volume has no such property), outOfMemory, volumeOutOfMemory (some bricks are then
/// changed and others not; the function may be called again).
Result<void> repaint(RunVolume& volume, PropertyIndex property, int axis, double from, double to);

} // namespace burin
