// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/runs/run_volume_impl.h"

#include <utility>

namespace burin {

/// Counts the scanlines of a tile that lie in the grid.
void RunVolume::Impl::count(LineIndex corner, const Tile& tile, bool add) noexcept {
    for (int i = 0; i < linesPerTile; ++i)
        if (store_->grid.contains(LineIndex{corner.u + i % tileSide, corner.v + i / tileSide}))
            count(tile.line(i), add);
}

bool RunVolume::Impl::setBrick(LineIndex corner, const BrickLines& lines) noexcept {
    BlockIndex* const entry = writableEntry(corner);
    if (entry == nullptr) return false;
    const Tile present = store_->tile(*entry);
    const std::uint32_t needed = lines.segmentCount();
    // A block of more than twice the size is better released.
    const bool fits =
        needed <= present.header().capacity && store_->arena->bytesOf(present.header()) <= 2 * Tile::bytesFor(needed);
    const bool inPlace = fits && present.header().users == 1 && isOwn(*entry);
    const BlockIndex fresh = inPlace ? *entry : allocateTile(needed);
    if (fresh == noBlock) return false;
    count(corner, present, false);
    const Tile tile = store_->tile(fresh);
    tile.copyFrom(lines);
    count(corner, tile, true);
    if (inPlace) return true;
    tile.header().users = 1;
    drop(std::exchange(*entry, fresh));
    return true;
}

bool RunVolume::Impl::shareBrick(LineIndex corner, LineIndex other) noexcept {
    BlockIndex* const entry = writableEntry(corner);
    if (entry == nullptr) return false;
    const auto place = static_cast<std::size_t>(TileTable::entryOf(other));
    const BlockIndex shared = store_->page(pages_[store_->table.pageOf(other)])[place];
    if (*entry == shared) return true;
    count(corner, store_->tile(*entry), false);
    count(corner, store_->tile(shared), true);
    ++header(shared).users;
    drop(std::exchange(*entry, shared));
    return true;
}

} // namespace burin
