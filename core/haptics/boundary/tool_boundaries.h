// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/boundary/boundary_layers.h"
#include "core/machine/envelope.h"
#include "core/setup/obstacle.h"
#include "core/tool/tool.h"

#include <span>

namespace burin {

/// Further layers around a tool: layer 1 + i is obstacle i, as a mesh; the machine's envelope, where it sets a limit,
/// is the last. Allocates. @param voxel mm, of the workpiece
void addLayers(BoundaryLayers& layers, std::span<const ObstacleSolid> obstacles, const Envelope& envelope,
               const Tool& tool, double voxel);
/// The same, with trees of their own.
void addLayers(BoundaryLayers& layers, std::span<const Obstacle> obstacles, const Envelope& envelope, const Tool& tool,
               double voxel);

} // namespace burin
