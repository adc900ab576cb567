// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/run_volume_impl.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace burin {

namespace {

/// A stretch of air within one run makes three segments of one.
constexpr std::uint32_t mostAddedByLine = 2;

} // namespace

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
    return allocateTile(present.segmentCount() + mostAddedByLine * linesPerTile);
}

/// Appends a line without the machinable runs between `from` and `to`; neighbours of one property become one.
Segment* RunVolume::Impl::clearLine(std::span<const Segment> line, RunPosition from, RunPosition to,
                                    Segment* place) noexcept {
    const Segment* const begin = place;
    const auto append = [&](RunPosition end, PropertyIndex property) {
        if (place != begin && place[-1].property() == property) --place;
        *place++ = Segment(end, property);
    };
    RunPosition start = 0;
    const Segment* next = line.data();
    const Segment* const last = next + line.size();
    for (; next != last && next->end() <= from; ++next) {
        *place++ = *next;
        start = next->end();
    }
    for (; next != last && start < to; ++next) {
        const RunPosition end = next->end();
        const PropertyIndex property = next->property();
        if (!machinable_[property]) {
            append(end, property);
        } else {
            const RunPosition low = std::max(start, from), high = std::min(end, to);
            if (start < low) append(low, property);
            append(high, airProperty);
            if (high < end) append(end, property);
            amounts_.units[property] -= high - low;
            amounts_.units[airProperty] += high - low;
        }
        start = end;
    }
    if (next != last) append(next->end(), next->property()), ++next;
    return std::copy(next, last, place);
}

/// Writes a brick anew, without what is to be removed.
void RunVolume::Impl::writeCleared(const Tile& present, const BrickSpans& spans, const Tile& tile) noexcept {
    Segment* place = tile.segments();
    const Segment* const begin = place;
    for (int line = 0; line < linesPerTile; ++line) {
        const std::span<const Segment> segments = present.line(line);
        const auto i = static_cast<std::size_t>(line);
        tile.setOffset(line, static_cast<std::uint32_t>(place - begin));
        place = (spans.lines >> line & 1) != 0 ? clearLine(segments, spans.from[i], spans.to[i], place)
                                               : std::copy(segments.begin(), segments.end(), place);
    }
    tile.setOffset(linesPerTile, static_cast<std::uint32_t>(place - begin));
}

bool RunVolume::Impl::clear(LineIndex index, const BrickSpans& spans, BlockIndex& room) noexcept {
    BlockIndex* const entry = writableEntry(index);
    if (entry == nullptr) return false;
    static_cast<void>(sparePage(store_->table.pageOf(index)));
    const Tile present = store_->tile(*entry);
    const std::uint32_t most =
        present.segmentCount() + mostAddedByLine * static_cast<std::uint32_t>(std::popcount(spans.lines));
    if (room == noBlock || store_->tile(room).header().capacity < most) {
        const BlockIndex larger = allocateTile(most);
        if (larger == noBlock) return false;
        if (room != noBlock) store_->arena->release(room);
        room = larger;
    }
    writeCleared(present, spans, store_->tile(room));
    // What was set aside is for the worst case; keep no more than it takes.
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
