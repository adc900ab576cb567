// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/run_volume.h"
#include "tests/benchmarks/peers/voxel_tool.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace burin::benchmarks {

/// Removed voxels by property.
using VoxelCounts = std::array<std::uint64_t, 256>;

/// Another method to mill whole voxels of 1 mm, axis +Z, runs along z: the same job for which MaterialRemoval is timed.
/// All peers use poses less than a voxel apart (the start pose of the move is cut already), remove a voxel if its
/// centre is inside the tool at one of them, and count removed voxels by property.
class CuttingPeer {
public:
    virtual ~CuttingPeer() = default;
    /// Starts a replay: the state with which the peer was made, tool at a tip where nothing is cut yet.
    virtual void restart() = 0;
    /// The work of one tick. @param removed  is increased
    virtual void cut(const glm::dvec3& from, const glm::dvec3& to, VoxelCounts& removed) = 0;
    virtual PropertyIndex at(VoxelIndex voxel) const = 0;
};

/// Scanlines low … high (inclusive) that a path of tips can change.
struct LineBlock {
    LineIndex low, high;
    bool holds(LineIndex line) const noexcept {
        return line.u >= low.u && line.u <= high.u && line.v >= low.v && line.v <= high.v;
    }
};
LineBlock blockOf(std::span<const glm::dvec3> tips, double radius, const Grid& grid);

/// The paper's method: the union of the voxelised tool at all poses as a list of runs for each line, its intersection
/// with the workpiece's runs, and their removal; each line has a vector of its own for its runs.
std::unique_ptr<CuttingPeer> paperCutter(const VolumeSnapshot& workpiece, const LineBlock& block, const EndMill& tool);
/// One byte per voxel, lines along z; only voxels that the previous pose did not reach are examined.
std::unique_ptr<CuttingPeer> denseByteCutter(const VolumeSnapshot& workpiece, const LineBlock& block,
                                             const EndMill& tool);
/// The same with one bit per voxel, 64 at a time. Has no materials: everything counts as property 1.
std::unique_ptr<CuttingPeer> denseBitCutter(const VolumeSnapshot& workpiece, const LineBlock& block,
                                            const EndMill& tool);

} // namespace burin::benchmarks
