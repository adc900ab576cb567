// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/run_volume.h"

namespace burin::benchmarks {

// Workpieces that the benchmarks mill, cubes of `side` voxels of 1 mm, so that lengths in mm are voxels. Four materials
// of stock and a part; all are machinable, so that a cutter may move anywhere.

inline constexpr int materialCount = 5;
PropertyList sceneMaterials();
Grid sceneGrid(std::int32_t side, RunAxis axis = RunAxis::z);

/// A block with a margin of 3 % of air on all sides: four oblique layers of stock with a bumpy part inside, about 3.5
/// runs per line.
RunVolume layeredBlock(std::int32_t side, RunAxis axis = RunAxis::z);

/// The lower half of such a block, stretched to the full height of the grid: stock that is milled from above.
RunVolume halfBlock(std::int32_t side);

/// Another such block that overlaps the first one: shifted by about a tenth of its side, by a different amount in each
/// direction.
RunVolume shiftedBlock(std::int32_t side);
/// The extent of the two blocks, whatever the material, mm.
Box layeredBlockBox(double side);
Box shiftedBlockBox(double side);

/// The first block after a finished freeform surface was milled into it, with scallops of a ball of R 25 every 8
/// voxels.
RunVolume scallopedFreeform(std::int32_t side);

/// A gyroid of one material.
/// @param runsPerLine  how often a line in the direction of the runs meets it
RunVolume gyroidLattice(std::int32_t side, int runsPerLine);

/// A plain block of one material that fills its grid.
RunVolume plainBlock(const glm::ivec3& extent);

/// Stock of one material for a slot: up to a height, and on one side of a vertical plane or on both.
struct SlotStock {
    glm::ivec3 extent{1}; ///< voxels along x, y, z
    double edge = 1.0;    ///< of a voxel, mm
    RunAxis axis = RunAxis::z;
    double top = 0.0;  ///< voxels above the grid's low face, whole
    bool half = false; ///< stock only where dot(side, (x, y) - through) > 0
    glm::dvec2 side{0.0};
    glm::dvec2 through{0.0}; ///< voxels
};
/// Runs along z or x.
RunVolume slotStock(const SlotStock& stock);

/// The number of runs that are not air.
std::uint64_t countRuns(const VolumeSnapshot& volume);

} // namespace burin::benchmarks
