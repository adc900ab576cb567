// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/boundary/tool_boundaries.h"

#include "core/haptics/boundary/envelope_boundary.h"
#include "core/haptics/boundary/mesh_boundary.h"

namespace burin {

void addLayers(BoundaryLayers& layers, std::span<const ObstacleSolid> obstacles, const Envelope& envelope,
               const Tool& tool, double voxel) {
    for (const ObstacleSolid& obstacle : obstacles)
        layers.add(std::make_unique<MeshBoundary>(obstacle.surface, pieces(tool.cutter), voxel, obstacle.margin),
                   obstacle.on);
    if (!envelope.tips.empty() || !envelope.tools.empty())
        layers.add(std::make_unique<EnvelopeBoundary>(envelope, pieces(tool.cutter), voxel));
}

void addLayers(BoundaryLayers& layers, std::span<const Obstacle> obstacles, const Envelope& envelope, const Tool& tool,
               double voxel) {
    addLayers(layers, std::span<const ObstacleSolid>(solidsOf(obstacles)), envelope, tool, voxel);
}

} // namespace burin
