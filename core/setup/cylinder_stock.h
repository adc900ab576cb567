// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/setup/cylinder_shape.h"
#include "core/volume/runs/run_volume.h"

namespace burin {

/// Fills what a cylinder holds of a volume, whichever way its axis lies. Exact: where a scanline's centre enters and
/// leaves it, to 1/256 voxel. Writer's thread, not for the haptic loop.
/// @return false: out of reserved memory; some scanlines are filled already
bool fillCylinder(RunVolume& volume, const CylinderShape& cylinder, PropertyIndex property);

} // namespace burin
