// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/volume_store.h"

namespace burin {

/// The writer's side of a volume: the current table of tiles, copy on write, and the edits of one scanline.
class RunVolume::Impl {
public:
    /// @throws std::bad_alloc
    explicit Impl(std::shared_ptr<VolumeStore> store);
    /// Allocates every page of the table and one shared tile of air. False: out of memory.
    bool fillWithAir() noexcept;

    const VolumeStore& store() const noexcept { return *store_; }
    const RunAmounts& amounts() const noexcept { return amounts_; }
    std::span<const Segment> line(LineIndex index) const noexcept { return store_->line(pages_, index); }
    std::span<const Segment> brick(LineIndex index) const noexcept { return store_->tileAt(pages_, index).all(); }

    void fetch(LineIndex index) const noexcept;

    Removal removeSpan(LineIndex index, RunPosition from, RunPosition to, RunAmounts& removed) noexcept;
    bool fillSpan(LineIndex index, RunPosition from, RunPosition to, PropertyIndex property) noexcept;
    bool fillBlock(LineIndex low, LineIndex high, RunPosition from, RunPosition to, PropertyIndex property) noexcept;
    bool setLine(LineIndex index, std::span<const Segment> segments) noexcept;
    bool rewriteBricks(const std::function<void(std::int32_t row, BrickSink& sink)>& describe);
    /// Replaces the content of the brick at `corner`; scanlines beyond the grid are ignored. False if the reserved
    /// memory is used up; the brick is then unchanged.
    bool setBrick(LineIndex corner, const BrickLines& lines) noexcept;
    /// Makes the brick at `corner` share the block of the one at `other`. False if the reserved memory is used up; the
    /// brick is then unchanged.
    bool shareBrick(LineIndex corner, LineIndex other) noexcept;

    /// Joins small free blocks into large ones. Outside the haptic loop. @throws std::bad_alloc
    void joinFreeMemory();

    /// A block for a brick with two more segments per line than it has now, or noBlock if out of memory.
    BlockIndex setAside(LineIndex index) noexcept;
    void giveBack(BlockIndex block) noexcept { store_->arena->release(block); }
    /// @param room  consumed, then noBlock
    bool clear(LineIndex index, const BrickSpans& spans, BlockIndex& room) noexcept;
    bool hasPagesToSpare() const noexcept { return lackingPages_ == 0; }

    VolumeState* snapshot();
    void restore(const VolumeState& state);

private:
    class BrickRewrite;

    /// A tile that was filled to become equal to another: the same interval of every line was set.
    struct EqualFill {
        BlockIndex before = noBlock, after = noBlock;
    };

    BlockHeader& header(BlockIndex block) const noexcept { return *store_->arena->at(block); }
    bool isOwn(BlockIndex block) const noexcept { return header(block).birth > lastSnapshot_ || !store_->hasReaders(); }
    BlockIndex allocate(std::size_t bytes) noexcept;
    void releaseUnseen() noexcept;
    BlockIndex allocateTile(std::uint32_t segments) noexcept;
    BlockIndex* writableEntry(LineIndex index) noexcept;
    std::optional<Tile> writableTile(LineIndex index, std::uint32_t added) noexcept;
    void drop(BlockIndex block) noexcept;
    RunPosition removeFew(const Tile& tile, int line, RunPosition from, RunPosition to, RunAmounts& removed) noexcept;
    bool fillTile(LineIndex low, LineIndex high, RunPosition from, RunPosition to, PropertyIndex property,
                  EqualFill& known) noexcept;
    void count(std::span<const Segment> line, bool add) noexcept;
    void count(LineIndex corner, const Tile& tile, bool add) noexcept;
    bool sparePage(std::size_t page) noexcept;

    std::shared_ptr<VolumeStore> store_;
    std::array<bool, 256> machinable_{}; ///< by property
    std::vector<BlockIndex> pages_;
    std::vector<BlockIndex> sparePages_; ///< by page: spare copy, for pages with bricks that have room set aside
    std::size_t lackingPages_ = 0;       ///< number of pages that used their spare and could not get another
    std::vector<bool> lacks_;            ///< those pages
    RunAmounts amounts_;
    std::uint64_t epoch_ = 1;        ///< birth epoch of blocks made now
    std::uint64_t lastSnapshot_ = 0; ///< epoch of the newest snapshot
    DeadList dead_;                  ///< died since the newest snapshot, which shows them
};

} // namespace burin
