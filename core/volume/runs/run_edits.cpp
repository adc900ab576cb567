// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/runs/run_volume_impl.h"

#include <algorithm>
#include <cassert>

namespace burin {

namespace {

/// Segments in order, with neighbours of one property merged; holds a few.
template <std::size_t capacity>
class SegmentList {
public:
    void append(RunPosition end, PropertyIndex property) noexcept {
        if (count_ > 0 && segments_[count_ - 1].property() == property) --count_;
        assert(count_ < capacity);
        segments_[count_++] = Segment(end, property);
    }
    std::uint32_t size() const noexcept { return static_cast<std::uint32_t>(count_); }
    void writeTo(Segment* place) const noexcept { std::copy_n(segments_.begin(), count_, place); }

private:
    std::array<Segment, capacity> segments_;
    std::size_t count_ = 0;
};

std::size_t firstEndingAfter(std::span<const Segment> line, RunPosition position) noexcept {
    const auto found = std::ranges::partition_point(line, [=](Segment segment) { return segment.end() <= position; });
    return static_cast<std::size_t>(found - line.begin());
}

RunPosition startOf(std::span<const Segment> line, std::size_t segment) noexcept {
    return segment == 0 ? 0 : line[segment - 1].end();
}

/// Maximum number of segments in one edit step; two more are its neighbours, two more come from splitting its ends.
constexpr std::size_t fewSegments = 60;

} // namespace

Removal RunVolume::Impl::removeSpan(LineIndex index, RunPosition from, RunPosition to, RunAmounts& removed) noexcept {
    const PropertyList& properties = store_->properties;
    to = std::min(to, store_->grid.lineEnd());
    if (from >= to) return Removal::nothing;
    const std::span<const Segment> present = line(index);
    const auto machinable = [&](Segment s) {
        return s.property() != airProperty && !properties.isProtected(s.property());
    };
    std::size_t first = firstEndingAfter(present, from);
    while (first < present.size() && startOf(present, first) < to && !machinable(present[first])) ++first;
    if (first == present.size() || startOf(present, first) >= to) return Removal::nothing;

    // However much is removed, a line gains at most two segments: an interval of air within one run.
    const std::optional<Tile> tile = writableTile(index, 2);
    if (!tile) return Removal::outOfMemory;
    const int lineInTile = TileTable::lineInTile(index);
    while (from < to) from = removeFew(*tile, lineInTile, from, to, removed);
    return Removal::removed;
}

/// Removes from the first segments of an interval; returns the position that was reached.
RunPosition RunVolume::Impl::removeFew(const Tile& tile, int lineInTile, RunPosition from, RunPosition to,
                                       RunAmounts& removed) noexcept {
    const std::span<const Segment> present = tile.line(lineInTile);
    const std::size_t first = firstEndingAfter(present, from);
    const std::size_t begin = first == 0 ? 0 : first - 1;
    SegmentList<fewSegments + 4> changed;
    if (begin < first) changed.append(present[begin].end(), present[begin].property());
    std::size_t i = first;
    RunPosition start = startOf(present, first), reached = from;
    for (; i < present.size() && start < to && i - first < fewSegments; start = present[i].end(), ++i) {
        const RunPosition end = present[i].end();
        const PropertyIndex property = present[i].property();
        reached = std::min(end, to);
        if (property == airProperty || store_->properties.isProtected(property)) {
            changed.append(end, property);
            continue;
        }
        const RunPosition low = std::max(start, from);
        if (start < low) changed.append(low, property);
        changed.append(reached, airProperty);
        if (reached < end) changed.append(end, property);
        removed.units[property] += reached - low;
        amounts_.units[property] -= reached - low;
        amounts_.units[airProperty] += reached - low;
    }
    if (i < present.size()) {
        changed.append(present[i].end(), present[i].property());
        ++i;
    }
    changed.writeTo(tile.replace(lineInTile, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(i - begin),
                                 changed.size()));
    return reached;
}

bool RunVolume::Impl::fillSpan(LineIndex index, RunPosition from, RunPosition to, PropertyIndex property) noexcept {
    to = std::min(to, store_->grid.lineEnd());
    if (from >= to) return true;
    std::span<const Segment> present = line(index);
    std::size_t first = firstEndingAfter(present, from);
    if (present[first].property() == property && present[first].end() >= to) return true;
    const std::optional<Tile> tile = writableTile(index, 2);
    if (!tile) return false;

    const int lineInTile = TileTable::lineInTile(index);
    present = tile->line(lineInTile);
    const std::size_t begin = first == 0 ? 0 : first - 1;
    SegmentList<5> changed;
    if (begin < first) changed.append(present[begin].end(), present[begin].property());
    RunPosition start = startOf(present, first);
    if (start < from) changed.append(from, present[first].property());
    changed.append(to, property);
    std::size_t i = first;
    for (; start < to; start = present[i].end(), ++i)
        amounts_.units[present[i].property()] -= std::min(present[i].end(), to) - std::max(start, from);
    amounts_.units[property] += to - from;
    if (present[i - 1].end() > to)
        changed.append(present[i - 1].end(), present[i - 1].property());
    else if (i < present.size()) {
        changed.append(present[i].end(), present[i].property());
        ++i;
    }
    changed.writeTo(tile->replace(lineInTile, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(i - begin),
                                  changed.size()));
    return true;
}

bool RunVolume::Impl::setLine(LineIndex index, std::span<const Segment> segments) noexcept {
    const RunPosition lineEnd = store_->grid.lineEnd();
    assert(!segments.empty() && segments.back().end() == lineEnd);
    // Iterates over the resulting segments: none empty, none beyond the line, no two neighbours of one property.
    const auto walk = [&](auto&& emit) {
        Segment open(0, airProperty);
        for (const Segment segment : segments) {
            const RunPosition end = std::min(segment.end(), lineEnd);
            if (end <= open.end()) continue;
            if (open.end() > 0 && segment.property() != open.property()) emit(open);
            open = Segment(end, segment.property());
        }
        emit(Segment(lineEnd, open.property()));
    };
    std::uint32_t added = 0;
    walk([&](Segment) { ++added; });
    const auto present = static_cast<std::uint32_t>(line(index).size());
    const std::optional<Tile> tile = writableTile(index, added > present ? added - present : 0);
    if (!tile) return false;
    const int lineInTile = TileTable::lineInTile(index);
    count(tile->line(lineInTile), false);
    Segment* place = tile->replace(lineInTile, 0, present, added);
    walk([&](Segment segment) { *place++ = segment; });
    count(tile->line(lineInTile), true);
    return true;
}

void RunVolume::Impl::count(std::span<const Segment> segments, bool add) noexcept {
    RunPosition start = 0;
    for (const Segment segment : segments) {
        std::uint64_t& units = amounts_.units[segment.property()];
        units = add ? units + (segment.end() - start) : units - (segment.end() - start);
        start = segment.end();
    }
}

bool RunVolume::Impl::fillBlock(LineIndex low, LineIndex high, RunPosition from, RunPosition to,
                                PropertyIndex property) noexcept {
    const Grid& grid = store_->grid;
    low = {std::max(low.u, 0), std::max(low.v, 0)};
    high = {std::min(high.u, grid.lineCountU()), std::min(high.v, grid.lineCountV())};
    EqualFill known;
    for (std::int32_t v = low.v; v < high.v; v = (v / tileSide + 1) * tileSide)
        for (std::int32_t u = low.u; u < high.u; u = (u / tileSide + 1) * tileSide) {
            const LineIndex last{std::min((u / tileSide + 1) * tileSide, high.u),
                                 std::min((v / tileSide + 1) * tileSide, high.v)};
            if (!fillTile({u, v}, last, from, to, property, known)) return false;
        }
    return true;
}

bool RunVolume::Impl::fillTile(LineIndex low, LineIndex high, RunPosition from, RunPosition to, PropertyIndex property,
                               EqualFill& known) noexcept {
    const auto each = [&](auto&& visit) {
        for (std::int32_t v = low.v; v < high.v; ++v)
            for (std::int32_t u = low.u; u < high.u; ++u)
                if (!visit(LineIndex{u, v})) return false;
        return true;
    };
    const bool whole = high.u - low.u == tileSide && high.v - low.v == tileSide;
    BlockIndex* const entry = writableEntry(low);
    if (entry == nullptr) return false;
    const BlockIndex before = *entry;
    if (whole && before == known.before) {
        each([&](LineIndex index) {
            count(line(index), false);
            return true;
        });
        ++header(known.after).users;
        *entry = known.after;
        each([&](LineIndex index) {
            count(line(index), true);
            return true;
        });
        drop(before);
        return true;
    }
    const bool shared = header(before).users > 1;
    if (!each([&](LineIndex index) { return fillSpan(index, from, to, property); })) return false;
    // As long as others share the previous block it stays unchanged, so the next of them can take the same result.
    if (whole && shared) known = {before, *entry};
    return true;
}

} // namespace burin
