// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/run_volume.h"

#include <cstddef>

namespace burin {

/// What a state of a volume uses of the volume's reserved memory, in bytes. A tile that several positions share counts
/// once; everything that the arena allocated for the state is in one of the parts.
struct VolumeMemory {
    std::size_t lines = 0;        ///< scanlines of the grid
    std::size_t runs = 0;         ///< of material, over all scanlines; each use of a shared tile counts
    std::size_t places = 0;       ///< number of tiles of 8 × 8 scanlines in the grid
    std::size_t tiles = 0;        ///< number of different blocks that hold them
    std::size_t segmentBytes = 0; ///< segments, air included
    std::size_t headerBytes = 0;  ///< block headers and offsets of tiles
    std::size_t slackBytes = 0;   ///< unused capacity of tiles, because sizes come in steps
    std::size_t tableBytes = 0;   ///< pages and root of the table of tiles

    std::size_t bytes() const noexcept { return segmentBytes + headerBytes + slackBytes + tableBytes; }
    double bytesPerLine() const noexcept { return static_cast<double>(bytes()) / static_cast<double>(lines); }
    /// 0 if there is no run.
    double bytesPerRun() const noexcept {
        return runs == 0 ? 0.0 : static_cast<double>(bytes()) / static_cast<double>(runs);
    }
};

/// Counts tile by tile. Cost: grows with the scanlines (some ms at 1024 × 1024). Any thread.
/// @throws std::bad_alloc
VolumeMemory memoryOf(const VolumeSnapshot& snapshot);

/// Bytes of the reserved memory that `snapshot` uses and `other`, a snapshot of the same volume, does not: what is
/// freed when the first of the two is released and has no other holder. Cost: some ms for 2048 × 2048 scanlines.
std::size_t bytesHeldBack(const VolumeSnapshot& snapshot, const VolumeSnapshot& other);

} // namespace burin
