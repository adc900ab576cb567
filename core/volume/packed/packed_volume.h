// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/volume/packed/packed_tile.h"
#include "core/volume/runs/run_volume.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace burin {

/// What a volume held at one moment, packed: about a thirtieth of the volume's own memory and none of its reserve. To
/// be kept for long and read now and then. Immutable: any thread may read it.
class PackedVolume {
public:
    /// Cost: some µs a tile, shared among all cores. Errors: cancelled, outOfMemory.
    static Result<PackedVolume> pack(const VolumeSnapshot& snapshot, Progress& progress);

    const Grid& grid() const noexcept { return grid_; }
    const PropertyList& properties() const noexcept { return properties_; }
    const RunAmounts& amounts() const noexcept { return amounts_; }

    /// The brick of 8 × 8 scanlines around `line`, which must lie in the grid. Cost: 0.4–2 µs for a few runs a line.
    /// @param brick line 8 v + u, counted from the brick's low corner; those beyond the grid are of no account
    /// @throws std::bad_alloc
    void brick(LineIndex line, BrickLines& brick) const;
    /// Segments of one scanline, in order. Cost: that of its brick; for many lines ask for bricks.
    std::vector<Segment> line(LineIndex line) const;
    /// A volume that holds the same, for editing.
    /// @param reservedBytes as for assembleBricks
    /// Errors: cancelled, outOfMemory.
    Result<RunVolume> unpack(Progress& progress, std::size_t reservedBytes = 0) const;

    std::size_t tileBytes() const noexcept { return bytes_.capacity(); }
    std::size_t tableBytes() const noexcept { return starts_.capacity() * sizeof(std::uint64_t); }
    std::size_t memoryBytes() const noexcept { return tileBytes() + tableBytes() + sizeof *this; }

private:
    PackedVolume(const Grid& grid, PropertyList properties) : grid_(grid), properties_(std::move(properties)) {}

    Grid grid_;
    PropertyList properties_;
    RunAmounts amounts_;
    std::string bytes_;
    std::vector<std::uint64_t> starts_; ///< in `bytes_`, for each place of the table, row by row
};

} // namespace burin
