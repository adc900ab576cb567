// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/brick_lines.h"
#include "core/volume/runs/run_volume.h"

#include <cstdint>
#include <vector>

namespace burin {

/// The range of voxels along the runs within which a brick of scanlines holds anything, for all bricks of a volume and
/// for blocks of them: a single comparison with a tool excludes a thousand scanlines. A range is that of the moment
/// when the brick was last read; cutting only makes bricks emptier, so it remains a bound during cutting.
/// A brick that was not read yet may be full.
class OccupiedBricks {
public:
    static constexpr std::int32_t brickSide = burin::brickSide;
    static constexpr std::int32_t blockSide = 4 * brickSide; ///< scanlines

    struct Extent {
        std::uint16_t low = 0, high = 0; ///< voxels along the runs, high exclusive; empty when low >= high
        bool empty() const noexcept { return low >= high; }
    };

    /// Allocates 4 bytes a brick.
    explicit OccupiedBricks(const Grid& grid);

    /// The range of the brick or block that contains a scanline.
    Extent brick(LineIndex line) const noexcept { return bricks_[brickAt(line)]; }
    Extent block(LineIndex line) const noexcept { return blocks_[blockAt(line)]; }
    /// Reads the brick that contains a scanline. Cost: its 64 scanlines. No allocation.
    Extent lookAt(const RunVolume& volume, LineIndex line) noexcept;
    /// Assumes again that all bricks may be full. Cost: 4 bytes a brick. No allocation.
    void forget() noexcept;

private:
    std::size_t brickAt(LineIndex line) const noexcept {
        return static_cast<std::size_t>(line.v / brickSide) * bricksU_ + static_cast<std::size_t>(line.u / brickSide);
    }
    std::size_t blockAt(LineIndex line) const noexcept {
        return static_cast<std::size_t>(line.v / blockSide) * blocksU_ + static_cast<std::size_t>(line.u / blockSide);
    }

    std::size_t bricksU_ = 0, blocksU_ = 0;
    Extent full_;
    std::vector<Extent> bricks_, blocks_;
};

} // namespace burin
