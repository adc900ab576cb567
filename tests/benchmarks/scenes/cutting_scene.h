// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/run_volume.h"

namespace burin::benchmarks {

// Workpieces that the benchmarks mill, as cubes of `side` voxels of 1 mm, so that lengths in mm are voxels. Four
// materials of stock and a part; all machinable, so that a cutter may go anywhere.

inline constexpr int materialCount = 5;
PropertyList sceneMaterials();
Grid sceneGrid(std::int32_t side, RunAxis axis = RunAxis::z);

/// A block with a margin of 3 % of air all round: four oblique layers of stock with a bumpy part in them, about 3.5
/// runs a line.
RunVolume layeredBlock(std::int32_t side, RunAxis axis = RunAxis::z);

/// The same block after a finished freeform surface was milled down into it, scallops of a ball of R 25 every 8 voxels
/// and all.
RunVolume scallopedFreeform(std::int32_t side);

/// A gyroid of one material.
/// @param runsPerLine how often a line along the runs meets it
RunVolume gyroidLattice(std::int32_t side, int runsPerLine);

/// A plain block of one material that fills its grid but for a layer of air above it.
/// @param extent voxels along x, y, z
/// @param edge   of a voxel, mm
/// @param top    voxels from the grid's lower face to the block's upper one
RunVolume plainBlock(const glm::ivec3& extent, double edge, RunAxis axis, double top);

/// Runs that are not air.
std::uint64_t countRuns(const VolumeSnapshot& volume);

} // namespace burin::benchmarks
