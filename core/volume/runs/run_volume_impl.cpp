// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/runs/run_volume_impl.h"

#include <algorithm>
#include <utility>

namespace burin {

RunVolume::Impl::Impl(std::shared_ptr<VolumeStore> store) : store_(std::move(store)) {
    pages_.resize(store_->table.pageCount(), noBlock);
    sparePages_.resize(pages_.size(), noBlock);
    lacks_.resize(pages_.size());
    for (int i = 1; i < store_->properties.size(); ++i)
        machinable_[static_cast<std::size_t>(i)] = !store_->properties.isProtected(static_cast<PropertyIndex>(i));
}

bool RunVolume::Impl::fillWithAir() noexcept {
    const Grid& grid = store_->grid;
    const TileTable& table = store_->table;
    const BlockIndex air = allocateTile(linesPerTile);
    if (air == noBlock) return false;
    store_->tile(air).fill(Segment(grid.lineEnd(), airProperty));
    header(air).users = static_cast<std::uint32_t>(table.tilesU) * static_cast<std::uint32_t>(table.tilesV);
    for (BlockIndex& page : pages_) {
        page = allocate(TileTable::pageBytes());
        if (page == noBlock) return false;
        header(page).users = 1;
        std::ranges::fill(store_->page(page), noBlock);
    }
    for (LineIndex line; line.v < grid.lineCountV(); line.v += tileSide)
        for (line.u = 0; line.u < grid.lineCountU(); line.u += tileSide)
            store_->page(pages_[table.pageOf(line)])[static_cast<std::size_t>(TileTable::entryOf(line))] = air;
    amounts_.units[airProperty] = static_cast<std::uint64_t>(grid.lineEnd()) *
                                  static_cast<std::uint64_t>(grid.lineCountU()) *
                                  static_cast<std::uint64_t>(grid.lineCountV());
    return true;
}

void RunVolume::Impl::fetch(LineIndex index) const noexcept {
    // A fixed number of bytes: reading the block's size would mean waiting for it.
    constexpr std::size_t cacheLine = 64, usual = 1536;
    const auto* const begin = reinterpret_cast<const std::byte*>(&store_->tileAt(pages_, index).header());
    for (std::size_t at = 0; at < usual; at += cacheLine) __builtin_prefetch(begin + at, 0, 2);
}

BlockIndex RunVolume::Impl::allocate(std::size_t bytes) noexcept {
    BlockIndex block = store_->arena->allocate(bytes);
    if (block == noBlock && dead_.first != noBlock && !store_->hasReaders()) {
        releaseUnseen();
        block = store_->arena->allocate(bytes);
    }
    if (block != noBlock) header(block).birth = epoch_;
    return block;
}

/// The newest snapshot was released, so no reader sees what died since.
void RunVolume::Impl::releaseUnseen() noexcept {
    for (BlockIndex gone = dead_.first; gone != noBlock;) {
        const BlockIndex next = header(gone).next;
        store_->arena->release(gone);
        gone = next;
    }
    dead_ = {};
}

void RunVolume::Impl::joinFreeMemory() {
    if (!store_->hasReaders()) releaseUnseen();
    store_->arena->joinFreeBlocks();
}

BlockIndex RunVolume::Impl::allocateTile(std::uint32_t segments) noexcept {
    const BlockIndex block = allocate(Tile::bytesFor(segments));
    if (block != noBlock) store_->tile(block).format(store_->arena->bytesOf(header(block)), segments);
    return block;
}

/// Removes one reference of the current state to the block.
void RunVolume::Impl::drop(BlockIndex block) noexcept {
    if (--header(block).users > 0) return;
    if (isOwn(block))
        store_->arena->release(block);
    else
        dead_.push(*store_->arena, block);
}

BlockIndex* RunVolume::Impl::writableEntry(LineIndex index) noexcept {
    const std::size_t place = store_->table.pageOf(index);
    BlockIndex& page = pages_[place];
    if (!isOwn(page)) {
        BlockIndex copy = allocate(TileTable::pageBytes());
        if (copy == noBlock && sparePages_[place] != noBlock) {
            copy = std::exchange(sparePages_[place], noBlock);
            header(copy).birth = epoch_;
            lacks_[place] = true;
            ++lackingPages_;
        }
        if (copy == noBlock) return nullptr;
        header(copy).users = 1;
        std::ranges::copy(store_->page(page), store_->page(copy).begin());
        drop(std::exchange(page, copy));
    }
    return &store_->page(page)[static_cast<std::size_t>(TileTable::entryOf(index))];
}

/// The tile of a line, exclusive to this state, with room for `added` more segments.
std::optional<Tile> RunVolume::Impl::writableTile(LineIndex index, std::uint32_t added) noexcept {
    BlockIndex* const entry = writableEntry(index);
    if (entry == nullptr) return std::nullopt;
    const Tile present = store_->tile(*entry);
    const std::uint32_t needed = present.segmentCount() + added;
    if (present.header().users == 1 && needed <= present.header().capacity && isOwn(*entry)) return present;
    const BlockIndex copy = allocateTile(needed);
    if (copy == noBlock) return std::nullopt;
    const Tile tile = store_->tile(copy);
    tile.header().users = 1;
    tile.copyFrom(present);
    drop(std::exchange(*entry, copy));
    return tile;
}

VolumeState* RunVolume::Impl::snapshot() {
    VolumeState* const state = store_->obtainState();
    std::ranges::copy(pages_, state->pages.begin());
    state->amounts = amounts_;
    state->dead = std::exchange(dead_, {});
    state->epoch = lastSnapshot_ = epoch_++;
    state->store = store_;
    store_->publish(state);
    return state;
}

void RunVolume::Impl::restore(const VolumeState& state) {
    // First adopts all restored blocks, then drops all others: a block that several tiles share must not be released in
    // between.
    bool revived = false;
    const auto adopt = [&](BlockIndex block) { revived |= header(block).users++ == 0; };
    for (std::size_t p = 0; p < pages_.size(); ++p) {
        if (pages_[p] == state.pages[p]) continue;
        adopt(state.pages[p]);
        const auto present = store_->page(pages_[p]), old = store_->page(state.pages[p]);
        for (std::size_t entry = 0; entry < old.size(); ++entry)
            if (present[entry] != old[entry]) adopt(old[entry]);
    }
    if (revived) store_->unlistRevived(dead_);
    for (std::size_t p = 0; p < pages_.size(); ++p) {
        if (pages_[p] == state.pages[p]) continue;
        const auto present = store_->page(pages_[p]), old = store_->page(state.pages[p]);
        for (std::size_t entry = 0; entry < old.size(); ++entry)
            if (present[entry] != old[entry]) drop(present[entry]);
        drop(std::exchange(pages_[p], state.pages[p]));
    }
    amounts_ = state.amounts;
}

} // namespace burin
