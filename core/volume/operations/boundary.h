// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/run_volume.h"

#include <array>
#include <vector>

namespace burin {

/// Consecutive voxels first … last (inclusive) of one scanline.
struct VoxelInterval {
    std::int32_t first = 0, last = 0;
    friend bool operator==(VoxelInterval, VoxelInterval) = default;
};

/// The boundary voxels of an object: those with at least one empty voxel among their 26 neighbours (Chen & Yang 2004,
/// eq. 2, by the run criteria of section 4.2). Everything beyond the grid is empty. Kept as intervals of the scanlines
/// and updated where material was added or removed. Holds the snapshot that it was made from.
/// Thread: one at a time for updates; several threads may read.
class BoundaryList {
public:
    /// Finds the boundary of the whole volume. Parallel; cost: grows with its runs, not its voxels.
    /// @throws std::bad_alloc
    explicit BoundaryList(const VolumeSnapshot& volume);

    /// Updates the list to a later (or earlier) state of the same volume: only bricks of 8 × 8 scanlines that differ,
    /// and their neighbours, are examined again. For a snapshot of another volume the whole list is made anew.
    /// @return number of bricks examined
    /// @throws std::bad_alloc
    std::size_t update(const VolumeSnapshot& now);

    const VolumeSnapshot& shown() const noexcept { return shown_; }
    /// Boundary intervals of a scanline, in order; no two of them touch. Valid until the next update.
    std::span<const VoxelInterval> line(LineIndex line) const noexcept;
    std::uint64_t voxelCount() const noexcept;
    /// All voxels, ordered by scanline (v, then u) and then along the scanline. Parallel.
    /// @throws std::bad_alloc
    std::vector<VoxelIndex> voxels() const;

private:
    struct Brick {
        std::array<std::uint32_t, 65> begin{}; ///< by line, u counts fastest
        std::vector<VoxelInterval> intervals;
    };
    class Surrounding;
    class Finder;

    std::size_t brickAt(std::int32_t brickU, std::int32_t brickV) const noexcept {
        return static_cast<std::size_t>(brickV) * static_cast<std::size_t>(bricksU_) + static_cast<std::size_t>(brickU);
    }
    void findAll();

    VolumeSnapshot shown_;
    std::int32_t bricksU_ = 0, bricksV_ = 0;
    std::vector<Brick> bricks_;
};

/// Boundary voxels of one scanline, in order. Cost: grows with the runs of the line and of its eight neighbours.
std::vector<VoxelInterval> boundaryOfLine(const VolumeSnapshot& volume, LineIndex line);

/// All boundary voxels; as BoundaryList::voxels, without a list that can be updated.
std::vector<VoxelIndex> boundaryVoxels(const VolumeSnapshot& volume);

} // namespace burin
