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

/// The state of a volume at one moment, packed: takes about a thirtieth of the volume's own memory and none of its
/// reserve. Meant to be kept for long and read occasionally. Immutable: any thread may read it.
class PackedVolume {
public:
    /// Cost: some µs per tile, divided among all cores. Errors: cancelled, outOfMemory.
    static Result<PackedVolume> pack(const VolumeSnapshot& snapshot, Progress& progress);

    const Grid& grid() const noexcept { return grid_; }
    const PropertyList& properties() const noexcept { return properties_; }
    const RunAmounts& amounts() const noexcept { return amounts_; }

    /// The brick of 8 × 8 scanlines that contains `line`, which must lie in the grid. Cost: 0.4–2 µs for a few runs per
    /// line.
    /// @param brick  line 8 v + u, counted from the brick's low corner; lines beyond the grid are undefined
    /// @throws std::bad_alloc
    void brick(LineIndex line, BrickLines& brick) const;
    /// Segments of one scanline, in order. Cost: that of its brick; use `brick` for many lines.
    std::vector<Segment> line(LineIndex line) const;
    /// An editable volume with the same content.
    /// @param reservedBytes  as for assembleBricks
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
    std::vector<std::uint64_t> starts_; ///< index into `bytes_` for each entry of the table, row by row
};

} // namespace burin
