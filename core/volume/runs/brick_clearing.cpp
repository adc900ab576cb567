// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/runs/cleared_brick.h"
#include "core/volume/runs/run_volume_impl.h"

#include <bit>
#include <utility>

namespace burin {

bool RunVolume::Impl::sparePage(std::size_t page) noexcept {
    if (sparePages_[page] != noBlock) return true;
    sparePages_[page] = allocate(TileTable::pageBytes());
    if (sparePages_[page] == noBlock) return false;
    if (lacks_[page]) --lackingPages_;
    lacks_[page] = false;
    return true;
}

BlockIndex RunVolume::Impl::setAside(LineIndex index) noexcept {
    const std::size_t page = store_->table.pageOf(index);
    if (!sparePage(page)) return noBlock;
    const auto entry = static_cast<std::size_t>(TileTable::entryOf(index));
    const Tile present = store_->tile(store_->page(pages_[page])[entry]);
    return allocateTile(present.segmentCount() + kernels::mostAddedByLine * linesPerTile);
}

bool RunVolume::Impl::clear(LineIndex index, const BrickSpans& spans, BlockIndex& room) noexcept {
    BlockIndex* const entry = writableEntry(index);
    if (entry == nullptr) return false;
    static_cast<void>(sparePage(store_->table.pageOf(index)));
    const Tile present = store_->tile(*entry);
    const std::uint32_t most =
        present.segmentCount() + kernels::mostAddedByLine * static_cast<std::uint32_t>(std::popcount(spans.lines));
    if (room == noBlock || store_->tile(room).header().capacity < most) {
        const BlockIndex larger = allocateTile(most);
        if (larger == noBlock) return false;
        if (room != noBlock) store_->arena->release(room);
        room = larger;
    }
    kernels::writeCleared(present, spans, machinable_, store_->tile(room), amounts_);
    // The room is sized for the worst case; keep no more than is needed.
    const Tile cleared = store_->tile(room);
    if (const BlockIndex fitting = allocateTile(cleared.segmentCount()); fitting != noBlock) {
        if (header(fitting).sizeClass < header(room).sizeClass) {
            store_->tile(fitting).copyFrom(cleared);
            store_->arena->release(std::exchange(room, fitting));
        } else {
            store_->arena->release(fitting);
        }
    }
    header(room).users = 1;
    header(room).birth = epoch_;
    drop(std::exchange(*entry, std::exchange(room, noBlock)));
    return true;
}

} // namespace burin
