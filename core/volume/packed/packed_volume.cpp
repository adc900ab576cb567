// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/packed/packed_volume.h"

#include "core/base/parallel_progress.h"
#include "core/volume/packed/packed_blocks.h"
#include "core/volume/runs/assembly.h"

#include <algorithm>
#include <cassert>
#include <new>
#include <unordered_map>
#include <utility>

namespace burin {

namespace {

constexpr std::size_t bricksPerStage = 4096; ///< between checks for cancellation

Error cancelled(const char* work) {
    return {ErrorCode::cancelled, work, {}, {}};
}

/// Each block once, in the order of its first use, and which of them each position of the table has.
struct Blocks {
    std::vector<BlockIndex> different;
    std::vector<std::uint32_t> atPlace;
};

Blocks blocksOf(const VolumeState& state) {
    const TileTable& table = state.store->table;
    Blocks blocks;
    std::unordered_map<BlockIndex, std::uint32_t> known;
    for (std::int32_t v = 0; v < table.tilesV; ++v)
        for (std::int32_t u = 0; u < table.tilesU; ++u) {
            const BlockIndex block = VolumeAccess::tileAt(state, u, v);
            const auto [place, isNew] = known.try_emplace(block, static_cast<std::uint32_t>(known.size()));
            if (isNew) blocks.different.push_back(block);
            blocks.atPlace.push_back(place->second);
        }
    return blocks;
}

} // namespace

Result<PackedVolume> PackedVolume::pack(const VolumeSnapshot& snapshot, Progress& progress) try {
    const VolumeState& state = VolumeAccess::state(snapshot);
    const Blocks blocks = blocksOf(state);
    PackedVolume volume(snapshot.grid(), snapshot.properties());
    volume.amounts_ = state.amounts;
    InternedTiles tiles;
    std::vector<std::uint64_t> starts;
    const std::span<const BlockIndex> all = blocks.different;
    for (std::size_t first = 0; first < all.size(); first += bricksPerStage) {
        if (progress.cancelled()) return cancelled("packing");
        const PackedBlocks packed =
            packBlocks(*state.store, all.subspan(first, std::min(bricksPerStage, all.size() - first)));
        for (std::size_t i = 0; i + 1 < packed.starts.size(); ++i) starts.push_back(tiles.add(packed.tile(i)));
        progress.report(static_cast<double>(starts.size()) / static_cast<double>(all.size()));
    }
    volume.bytes_ = tiles.take();
    volume.starts_.reserve(blocks.atPlace.size());
    for (const std::uint32_t place : blocks.atPlace) volume.starts_.push_back(starts[place]);
    return volume;
} catch (const std::bad_alloc&) {
    return Error{ErrorCode::outOfMemory, "packing", {}, {}};
}

void PackedVolume::brick(LineIndex line, BrickLines& brick) const {
    const std::size_t place =
        static_cast<std::size_t>(line.v / tileSide) * static_cast<std::size_t>(TileTable(grid_).tilesU) +
        static_cast<std::size_t>(line.u / tileSide);
    const bool sound =
        unpackTile(std::string_view(bytes_).substr(starts_[place]), packedFrame(grid_, properties_), brick);
    assert(sound);
    static_cast<void>(sound);
}

std::vector<Segment> PackedVolume::line(LineIndex line) const {
    BrickLines lines(grid_.lineEnd());
    brick(line, lines);
    const std::span<const Segment> segments = lines.line(TileTable::lineInTile(line));
    return {segments.begin(), segments.end()};
}

Result<RunVolume> PackedVolume::unpack(Progress& progress, std::size_t reservedBytes) const {
    ParallelProgress shared(progress, static_cast<std::size_t>(TileTable(grid_).tilesV));
    Result<RunVolume> volume = assembleBricks(
        grid_, properties_,
        [&](std::int32_t row, BrickSink& sink) {
            if (progress.cancelled()) return;
            BrickLines lines(grid_.lineEnd());
            for (LineIndex corner{0, row * brickSide}; corner.u < grid_.lineCountU(); corner.u += brickSide) {
                brick(corner, lines);
                sink.put(corner, lines);
            }
            shared.add();
        },
        reservedBytes);
    if (progress.cancelled()) return cancelled("unpacking");
    return volume;
}

} // namespace burin
