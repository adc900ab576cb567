// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/block_arena.h"
#include "core/volume/runs/tile.h"

#include <atomic>
#include <memory>
#include <mutex>
#include <vector>

namespace burin {

class VolumeStore;

/// List of blocks that the writer no longer uses but a snapshot still shows; linked through their headers.
struct DeadList {
    BlockIndex first = noBlock, last = noBlock;

    void push(BlockArena& arena, BlockIndex block) noexcept;
    void append(BlockArena& arena, DeadList& other) noexcept; ///< `other` is empty afterwards
};

/// What a snapshot shows: the table of pages at one epoch.
class VolumeState {
public:
    std::atomic<std::uint32_t> readers{0};
    std::shared_ptr<VolumeStore> store; ///< set while there are readers
    std::uint64_t epoch = 0;            ///< shows blocks born in this epoch or before
    std::vector<BlockIndex> pages;
    RunAmounts amounts;

    // Below: guarded by the store's mutex once the writer has handed the state over.
    DeadList dead; ///< died between the previous snapshot and this one
    bool released = false;
    VolumeState* next = nullptr; ///< the next newer snapshot; also the link of inbox and pool
};

/// Table of tiles in two levels: pages of 16 × 16 tiles, and a root with the indices of the pages.
struct TileTable {
    static constexpr std::int32_t pageSide = 16; ///< tiles
    static constexpr int tilesPerPage = pageSide * pageSide;

    std::int32_t tilesU = 0, tilesV = 0, pagesU = 0, pagesV = 0;

    explicit TileTable(const Grid& grid) noexcept;
    std::size_t pageCount() const noexcept {
        return static_cast<std::size_t>(pagesU) * static_cast<std::size_t>(pagesV);
    }
    std::size_t pageOf(LineIndex line) const noexcept {
        constexpr auto side = static_cast<std::size_t>(tileSide * pageSide);
        return at(line.v) / side * static_cast<std::size_t>(pagesU) + at(line.u) / side;
    }
    static int entryOf(LineIndex line) noexcept {
        return static_cast<int>(at(line.v) / tileSide % pageSide * pageSide + at(line.u) / tileSide % pageSide);
    }
    static int lineInTile(LineIndex line) noexcept {
        return static_cast<int>(at(line.v) % tileSide * tileSide + at(line.u) % tileSide);
    }
    static std::size_t pageBytes() noexcept { return sizeof(BlockHeader) + tilesPerPage * sizeof(BlockIndex); }

private:
    /// Lines are never below 0; unsigned, so that the division by a power of two is a shift.
    static std::size_t at(std::int32_t line) noexcept { return static_cast<std::size_t>(line); }
};

/// What a volume and its snapshots share: the grid, the property list, the memory, and the record of which blocks are
/// still in use by which snapshot. A block that the writer replaces after snapshot S was taken goes on the list of dead
/// blocks of the next snapshot N. When S is released, the blocks on N's list that no snapshot before S shows are freed,
/// and the list of S itself is appended to that of N. So each block is freed exactly when its last reader leaves; the
/// work is done on that reader's thread.
class VolumeStore {
public:
    VolumeStore(const Grid& grid, PropertyList properties, std::unique_ptr<BlockArena> arena);

    const Grid grid;
    const PropertyList properties;
    const TileTable table;
    const std::unique_ptr<BlockArena> arena;

    std::span<BlockIndex> page(BlockIndex block) const noexcept {
        return {reinterpret_cast<BlockIndex*>(arena->at(block) + 1), TileTable::tilesPerPage};
    }
    Tile tile(BlockIndex block) const noexcept { return Tile(arena->at(block)); }
    Tile tileAt(const std::vector<BlockIndex>& pages, LineIndex index) const noexcept {
        return tile(page(pages[table.pageOf(index)])[static_cast<std::size_t>(TileTable::entryOf(index))]);
    }
    std::span<const Segment> line(const std::vector<BlockIndex>& pages, LineIndex index) const noexcept {
        return tileAt(pages, index).line(TileTable::lineInTile(index));
    }

    // ---- Writer's thread

    /// Returns a state to fill in; allocates only if more than 64 snapshots are held at once.
    VolumeState* obtainState();
    /// Hands a snapshot over to the readers.
    void publish(VolumeState* state) noexcept;
    /// False if nobody holds a snapshot, so that everything may be changed in place.
    bool hasReaders() const noexcept { return heldSnapshots_.load(std::memory_order_acquire) != 0; }
    /// Removes blocks that are in use again from all lists of dead blocks. Waits for a reader that is just leaving.
    void unlistRevived(DeadList& writers);

    // ---- Any thread

    /// Called when the last reader of `state` has gone.
    static void release(VolumeState* state) noexcept;

private:
    void receive() noexcept;
    void reclaim() noexcept;
    void freeYoungerThan(DeadList& list, std::uint64_t epoch) noexcept;
    void unlist(DeadList& list) noexcept;

    /// 32 strokes that can be undone, the current one, states waiting to be handed over and states that others look at
    /// (3 kB each, and 4 bytes more for every 128 x 128 scanlines).
    static constexpr int preparedStates = 64;

    std::vector<std::unique_ptr<VolumeState>> states_; ///< all states; writer's
    VolumeState* spare_ = nullptr;                     ///< writer's
    std::atomic<VolumeState*> returnedStates_{nullptr};
    std::atomic<VolumeState*> published_{nullptr}; ///< newest first
    std::atomic<std::uint32_t> heldSnapshots_{0};
    std::mutex mutex_;              ///< among readers; the writer locks it only to restore an old snapshot
    VolumeState* oldest_ = nullptr; ///< list of snapshots by epoch
};

} // namespace burin
