// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/boundary/boundary_layers.h"
#include "core/machine/envelope.h"
#include "core/setup/obstacle.h"
#include "core/tool/tool.h"

#include <span>

namespace burin {

/// Adds further layers: layer 1 + i is obstacle i, as a mesh; the last is the machine's envelope, if it sets a limit.
/// Allocates. @param voxel edge of the workpiece's voxels, mm
void addLayers(BoundaryLayers& layers, std::span<const ObstacleSolid> obstacles, const Envelope& envelope,
               const Tool& tool, double voxel);
/// The same, with search trees made for these layers.
void addLayers(BoundaryLayers& layers, std::span<const Obstacle> obstacles, const Envelope& envelope, const Tool& tool,
               double voxel);

} // namespace burin
