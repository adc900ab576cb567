// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/run_volume_impl.h"

#include <utility>

namespace burin {

void RunVolume::Impl::count(const TileView& lines, bool add) noexcept {
    for (const std::span<const Segment> line : lines) count(line, add);
}

bool RunVolume::Impl::setTile(LineIndex corner, const TileView& lines) noexcept {
    const Segment air(store_->grid.lineEnd(), airProperty);
    TileView content = lines;
    std::size_t segments = 0;
    for (int i = 0; i < linesPerTile; ++i) {
        std::span<const Segment>& line = content[static_cast<std::size_t>(i)];
        if (!store_->grid.contains(LineIndex{corner.u + i % tileSide, corner.v + i / tileSide})) line = {&air, 1};
        segments += line.size();
    }
    if (segments > std::size_t{store_->grid.lineEnd()} * linesPerTile) return false;
    BlockIndex* const entry = writableEntry(corner);
    if (entry == nullptr) return false;
    const Tile present = store_->tile(*entry);
    const auto needed = static_cast<std::uint32_t>(segments);
    const std::size_t bytes = store_->arena->bytesOf(present.header()), leastBytes = Tile::bytesFor(needed);
    // A block of twice the size is better given back.
    const bool fits = needed <= present.header().capacity && bytes <= 2 * leastBytes;
    const bool inPlace = fits && present.header().users == 1 && isOwn(*entry);
    const BlockIndex fresh = inPlace ? *entry : allocateTile(needed);
    if (fresh == noBlock) return false;
    // Scanlines beyond the grid are air before and after, so they leave the amounts as they are.
    count(present.view(), false);
    const Tile tile = store_->tile(fresh);
    tile.assign(content);
    count(tile.view(), true);
    if (inPlace) return true;
    tile.header().users = 1;
    drop(std::exchange(*entry, fresh));
    return true;
}

bool RunVolume::Impl::shareTile(LineIndex corner, LineIndex other) noexcept {
    BlockIndex* const entry = writableEntry(corner);
    if (entry == nullptr) return false;
    const auto place = static_cast<std::size_t>(TileTable::entryOf(other));
    const BlockIndex shared = store_->page(pages_[store_->table.pageOf(other)])[place];
    if (*entry == shared) return true;
    count(store_->tile(*entry).view(), false);
    count(store_->tile(shared).view(), true);
    ++header(shared).users;
    drop(std::exchange(*entry, shared));
    return true;
}

} // namespace burin
