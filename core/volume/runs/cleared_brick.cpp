// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/runs/cleared_brick.h"

#include "core/base/vectorised.h"

#include <algorithm>

namespace burin::kernels {

namespace {

using Machinable = std::array<bool, 256>;

/// Copies eight segments at once, whatever they contain.
BURIN_INLINE void copyFew(const Segment* from, Segment* to) noexcept {
    static_assert(sizeof(Segment) == sizeof(std::uint32_t));
    Words values;
    __builtin_memcpy(&values, from, sizeof values);
    __builtin_memcpy(static_cast<void*>(to), &values, sizeof values);
}

/// A line of any length and any properties.
Segment* clearLine(std::span<const Segment> line, RunPosition from, RunPosition to, const Machinable& machinable,
                   Segment* place, RunAmounts& amounts) noexcept {
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
        if (!machinable[property]) {
            append(end, property);
        } else {
            const RunPosition low = std::max(start, from), high = std::min(end, to);
            if (start < low) append(low, property);
            append(high, airProperty);
            if (high < end) append(end, property);
            amounts.units[property] -= high - low;
            amounts.units[airProperty] += high - low;
        }
        start = end;
    }
    if (next != last) append(next->end(), next->property()), ++next;
    return std::copy(next, last, place);
}

/// A line whose air interval is widened within the runs on either side, or whose last run is shortened, as in most
/// cases: no more than two ends move.
/// @param copy  of the line, with room for one more segment; is changed
/// @return number of segments of the changed copy; 0: another kind of line, and the copy is unchanged
BURIN_INLINE std::uint32_t moveEnds(const Segment* line, std::uint32_t count, RunPosition from, RunPosition to,
                                    const Machinable& machinable, Segment* copy, RunAmounts& amounts,
                                    std::uint64_t& cleared) noexcept {
    const Segment *const lineEnd = line + count, *air = line;
    RunPosition start = 0;
    for (; air->end() <= from; ++air) start = air->end();
    RunPosition below = 0, above = 0;
    PropertyIndex left = airProperty, right = airProperty;
    if (air->property() != airProperty) {
        left = air->property();
        if (!machinable[left] || start == from) return 0;
        below = air->end() - from;
        if (++air == lineEnd) {
            if (below != to - from) return 0;
            ++count;
        } else if (air->property() != airProperty) {
            return 0;
        }
    }
    if (air != lineEnd && air->end() != to) {
        if (air->end() > to || air + 1 == lineEnd || to >= air[1].end()) return 0;
        right = air[1].property();
        if (!machinable[right]) return 0;
        above = to - air->end();
    }
    amounts.units[left] -= below;
    if (above > 0) amounts.units[right] -= above;
    cleared += below + above;
    Segment* const place = copy + (air - line);
    if (below > 0) place[-1] = Segment(from, left);
    *place = Segment(to, airProperty);
    return count;
}

/// Lines of up to this many segments, nearly all, are copied at once.
constexpr std::uint32_t few = lanes;

} // namespace

BURIN_VECTORISED void writeCleared(const Tile& present, const BrickSpans& spans, const Machinable& machinable,
                                   const Tile& cleared, RunAmounts& amounts) noexcept {
    TileOffsets before, after;
    present.readOffsets(before);
    const Segment* const segments = present.segments();
    Segment* const begin = cleared.segments();
    const RunPosition *const lows = spans.from.data(), *const highs = spans.to.data();
    // Limits up to which eight segments can be read, and written regardless of the length of the previous lines.
    const std::uint32_t readable = present.header().capacity, writable = cleared.header().capacity;
    std::uint64_t left = spans.lines, moved = 0;
    std::uint32_t at = 0;
    for (std::size_t line = 0; line < linesPerTile; ++line, left >>= 1) {
        const std::uint32_t first = before[line], end = before[line + 1], count = end - first;
        const Segment* const from = segments + first;
        Segment* const place = begin + at;
        after[line] = at;
        const bool copied = count <= few && first + few <= readable && at + few < writable;
        if (copied)
            copyFew(from, place);
        else if ((left & 1) == 0)
            std::copy(from, segments + end, place);
        if ((left & 1) == 0) {
            at += count;
            continue;
        }
        const RunPosition low = lows[line], high = highs[line];
        const std::uint32_t changed = copied ? moveEnds(from, count, low, high, machinable, place, amounts, moved) : 0;
        if (changed > 0)
            at += changed;
        else
            at = static_cast<std::uint32_t>(clearLine({from, count}, low, high, machinable, place, amounts) - begin);
    }
    amounts.units[airProperty] += moved;
    after[linesPerTile] = at;
    cleared.writeOffsets(after);
}

} // namespace burin::kernels
