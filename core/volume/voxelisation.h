// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/geometry/triangle_mesh.h"
#include "core/volume/run_volume.h"

namespace burin {

/// What voxelising a mesh found out about it.
struct VoxelisationReport {
    std::size_t linesWithOddCrossings = 0; ///< scanlines where the mesh was not closed; they were left untouched
    std::size_t linesWithTurnedFaces = 0;  ///< closed, but faces do not agree on what is outside: filled by parity
    std::uint64_t filledUnits = 0;         ///< run units inside the mesh
    std::size_t clippedLines = 0;          ///< scanlines on which the mesh reached out of the grid
};

/// Fills the inside of a closed mesh with a property. Run ends lie where the scanline's centre crosses the surface, to
/// 1/256 voxel. Rule for overlapping shells: a place is inside where the winding number is not zero; a place exactly on
/// a triangle's edge is decided once for all triangles that share it, so that a closed mesh never gives an odd line.
/// Which way a whole shell is turned does not matter. Across the runs, vertices are taken to the nearest 1/65,536
/// voxel. Cost: time linear in triangles and crossings; parallel over slabs of scanlines. Errors: volumeOutOfMemory,
/// cancelled (some lines are filled then), argumentInvalid (a vertex that is not finite or a million times farther away
/// than the largest grid reaches).
Result<VoxelisationReport> voxelise(const TriangleMesh& mesh, PropertyIndex property, RunVolume& volume,
                                    Progress& progress);

} // namespace burin
