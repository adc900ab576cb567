// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/setup/cylinder_shape.h"
#include "core/volume/runs/run_volume.h"

namespace burin {

/// Fills the part of a volume that lies inside a cylinder of any orientation. The points where a scanline's centre line
/// enters and leaves the cylinder are exact to 1/256 voxel. Call on the writer's thread, not on the haptic thread.
/// @return false if the reserved memory is exhausted; some scanlines are then already filled
bool fillCylinder(RunVolume& volume, const CylinderShape& cylinder, PropertyIndex property);

} // namespace burin
