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

/// Another way to mill whole voxels of 1 mm, axis +Z, runs along z: the same job that MaterialRemoval is timed at. All
/// of them take poses less than a voxel apart (the pose that the move starts at is cut already), a voxel goes when its
/// centre lies in the tool at one of them, and they count what goes by property.
class CuttingPeer {
public:
    virtual ~CuttingPeer() = default;
    /// Begins a replay: the state that the peer was made with, tool at a tip where nothing is cut yet.
    virtual void restart() = 0;
    /// Work of one tick. @param removed is added to
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

/// The paper's way: union of the voxelised tool at all poses as a list of runs for each line, its intersection with
/// the workpiece's runs, and their removal; runs of a line in a vector of its own.
std::unique_ptr<CuttingPeer> paperCutter(const VolumeSnapshot& workpiece, const LineBlock& block, const EndMill& tool);
/// A byte a voxel, lines along z; only what the pose before did not reach is looked at.
std::unique_ptr<CuttingPeer> denseByteCutter(const VolumeSnapshot& workpiece, const LineBlock& block,
                                             const EndMill& tool);
/// A bit a voxel, 64 at a time, likewise. Knows no materials: everything counts as property 1.
std::unique_ptr<CuttingPeer> denseBitCutter(const VolumeSnapshot& workpiece, const LineBlock& block,
                                            const EndMill& tool);

} // namespace burin::benchmarks
