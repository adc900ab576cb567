// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/runs/volume_memory.h"

#include "core/volume/runs/volume_access.h"

#include <algorithm>
#include <iterator>
#include <vector>

namespace burin {

namespace {

std::size_t materialRuns(std::span<const Segment> segments) {
    return static_cast<std::size_t>(
        std::ranges::count_if(segments, [](Segment segment) { return segment.property() != airProperty; }));
}

/// Runs of material in all scanlines of the grid.
std::size_t runsOf(const VolumeState& state) {
    const VolumeStore& store = *state.store;
    const Grid& grid = store.grid;
    std::size_t runs = 0;
    for (LineIndex corner; corner.v < grid.lineCountV(); corner.v += tileSide)
        for (corner.u = 0; corner.u < grid.lineCountU(); corner.u += tileSide) {
            const Tile tile = store.tile(VolumeAccess::tileAt(state, corner.u / tileSide, corner.v / tileSide));
            if (grid.contains(LineIndex{corner.u + tileSide - 1, corner.v + tileSide - 1})) {
                runs += materialRuns(tile.all());
                continue;
            }
            for (int i = 0; i < linesPerTile; ++i)
                if (grid.contains(LineIndex{corner.u + i % tileSide, corner.v + i / tileSide}))
                    runs += materialRuns(tile.line(i));
        }
    return runs;
}

std::vector<BlockIndex> blocksOf(const VolumeState& state) {
    const TileTable& table = state.store->table;
    std::vector<BlockIndex> blocks;
    blocks.reserve(static_cast<std::size_t>(table.tilesU) * static_cast<std::size_t>(table.tilesV));
    for (std::int32_t v = 0; v < table.tilesV; ++v)
        for (std::int32_t u = 0; u < table.tilesU; ++u) blocks.push_back(VolumeAccess::tileAt(state, u, v));
    return blocks;
}

} // namespace

VolumeMemory memoryOf(const VolumeSnapshot& snapshot) {
    const VolumeState& state = VolumeAccess::state(snapshot);
    const VolumeStore& store = *state.store;
    VolumeMemory memory;
    memory.lines =
        static_cast<std::size_t>(store.grid.lineCountU()) * static_cast<std::size_t>(store.grid.lineCountV());
    memory.tableBytes = state.pages.size() * sizeof(BlockIndex);
    for (const BlockIndex page : state.pages) memory.tableBytes += store.arena->bytesOf(*store.arena->at(page));
    std::vector<BlockIndex> blocks = blocksOf(state);
    memory.places = blocks.size();
    memory.runs = runsOf(state);
    std::ranges::sort(blocks);
    for (std::size_t i = 0; i < blocks.size();) {
        std::size_t next = i;
        while (next < blocks.size() && blocks[next] == blocks[i]) ++next;
        const Tile tile = store.tile(blocks[i]);
        const std::size_t all = store.arena->bytesOf(tile.header());
        const std::size_t segments = tile.segmentCount() * sizeof(Segment);
        const std::size_t header = Tile::bytesFor(tile.segmentCount()) - segments;
        ++memory.tiles;
        memory.segmentBytes += segments;
        memory.headerBytes += header;
        memory.slackBytes += all - segments - header;
        i = next;
    }
    return memory;
}

std::size_t bytesHeldBack(const VolumeSnapshot& snapshot, const VolumeSnapshot& other) {
    if (!snapshot.sameVolume(other)) return 0;
    const VolumeState &own = VolumeAccess::state(snapshot), &others = VolumeAccess::state(other);
    const VolumeStore& store = *own.store;
    std::vector<BlockIndex> held;
    std::size_t bytes = 0;
    for (std::size_t p = 0; p < own.pages.size(); ++p) {
        if (own.pages[p] == others.pages[p]) continue;
        bytes += store.arena->bytesOf(*store.arena->at(own.pages[p]));
        const auto mine = store.page(own.pages[p]), theirs = store.page(others.pages[p]);
        for (std::size_t entry = 0; entry < mine.size(); ++entry)
            if (mine[entry] != theirs[entry] && mine[entry] != noBlock) held.push_back(mine[entry]);
    }
    const auto sortedOnce = [](std::vector<BlockIndex>& blocks) {
        std::ranges::sort(blocks);
        blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
    };
    sortedOnce(held);
    std::vector<BlockIndex> shown = held.empty() ? std::vector<BlockIndex>{} : blocksOf(others), alone;
    sortedOnce(shown); // what one position lost may still be shared by others
    std::ranges::set_difference(held, shown, std::back_inserter(alone));
    for (const BlockIndex block : alone) bytes += store.arena->bytesOf(*store.arena->at(block));
    return bytes;
}

} // namespace burin
