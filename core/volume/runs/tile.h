// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/block_arena.h"
#include "core/volume/runs/brick_lines.h"
#include "core/volume/runs/run_volume.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <span>

namespace burin {

// A tile holds 8 × 8 scanlines in one block: header, 65 offsets (where each line's segments begin, and the end of the
// last), the segments of all lines without a gap, and some spare room. Offsets are 16 bits wide, or 32 bits in a tile
// of more than 65,535 segments, so that the number of runs is not limited.
inline constexpr std::int32_t tileSide = brickSide;
inline constexpr int linesPerTile = linesPerBrick;
inline constexpr std::uint32_t narrowLimit = 0xffff;

/// The scanlines of a tile for reading, line 8 v + u; non-owning views.
using TileView = std::array<std::span<const Segment>, linesPerTile>;

/// Where the segments of each line begin, and the end of the last, counted from the first segment of the tile.
using TileOffsets = std::array<std::uint32_t, linesPerTile + 1>;

/// Access to the content of a tile's block; owns nothing.
class Tile {
public:
    explicit Tile(BlockHeader* header) noexcept : header_(header) {}

    static std::size_t bytesFor(std::uint32_t segments) noexcept {
        return segmentsAt(segments > narrowLimit) + std::size_t{segments} * sizeof(Segment);
    }
    /// Initialises a new block for at least `needed` segments.
    void format(std::size_t blockBytes, std::uint32_t needed) noexcept {
        header_->wide = needed > narrowLimit;
        const std::size_t room = (blockBytes - segmentsAt(header_->wide)) / sizeof(Segment);
        header_->capacity = static_cast<std::uint32_t>(header_->wide || room < narrowLimit ? room : narrowLimit);
    }

    BlockHeader& header() const noexcept { return *header_; }
    std::uint32_t offset(int line) const noexcept {
        return header_->wide ? wideOffsets()[line] : narrowOffsets()[line];
    }
    std::uint32_t segmentCount() const noexcept { return offset(linesPerTile); }
    Segment* segments() const noexcept { return reinterpret_cast<Segment*>(bytes() + segmentsAt(header_->wide)); }
    std::span<const Segment> all() const noexcept { return {segments(), segmentCount()}; }
    std::span<const Segment> line(int line) const noexcept {
        const std::uint32_t begin = offset(line);
        return {segments() + begin, offset(line + 1) - begin};
    }

    TileView view() const noexcept {
        TileView lines;
        for (int i = 0; i < linesPerTile; ++i) lines[static_cast<std::size_t>(i)] = line(i);
        return lines;
    }

    /// Sets every line to the same single segment.
    void fill(Segment segment) const noexcept {
        for (int line = 0; line <= linesPerTile; ++line) setOffset(line, static_cast<std::uint32_t>(line));
        for (int line = 0; line < linesPerTile; ++line) segments()[line] = segment;
    }
    void copyFrom(const Tile& other) const noexcept {
        if (header_->wide || other.header_->wide)
            for (int line = 0; line <= linesPerTile; ++line) setOffset(line, other.offset(line));
        else
            std::memcpy(narrowOffsets(), other.narrowOffsets(), (linesPerTile + 1) * sizeof(std::uint16_t));
        std::memcpy(segments(), other.segments(), other.segmentCount() * sizeof(Segment));
    }
    void copyFrom(const BrickLines& lines) const noexcept {
        if (header_->wide)
            for (int line = 0; line <= linesPerTile; ++line) wideOffsets()[line] = lines.offset(line);
        else
            for (int line = 0; line <= linesPerTile; ++line)
                narrowOffsets()[line] = static_cast<std::uint16_t>(lines.offset(line));
        std::memcpy(segments(), lines.segments().data(), lines.segmentCount() * sizeof(Segment));
    }
    bool operator==(const BrickLines& lines) const noexcept {
        return segmentCount() == lines.segmentCount() &&
               std::memcmp(segments(), lines.segments().data(), segmentCount() * sizeof(Segment)) == 0;
    }
    /// Makes room for `added` segments in place of `removed` ones of a line, starting at its segment `first`. The
    /// caller has to ensure the capacity and to write the new segments to the returned position.
    Segment* replace(int line, std::uint32_t first, std::uint32_t removed, std::uint32_t added) const noexcept {
        const std::uint32_t at = offset(line) + first;
        const std::uint32_t total = segmentCount();
        Segment* const place = segments() + at;
        if (added != removed) {
            std::memmove(place + added, place + removed, (total - at - removed) * sizeof(Segment));
            for (int later = line + 1; later <= linesPerTile; ++later)
                setOffset(later, offset(later) + added - removed);
        }
        return place;
    }
    void readOffsets(TileOffsets& offsets) const noexcept {
        if (header_->wide)
            std::copy_n(wideOffsets(), offsets.size(), offsets.begin());
        else
            std::copy_n(narrowOffsets(), offsets.size(), offsets.begin());
    }
    void writeOffsets(const TileOffsets& offsets) const noexcept {
        if (header_->wide)
            std::ranges::copy(offsets, wideOffsets());
        else
            std::ranges::transform(offsets, narrowOffsets(),
                                   [](std::uint32_t offset) { return static_cast<std::uint16_t>(offset); });
    }
    void setOffset(int line, std::uint32_t value) const noexcept {
        if (header_->wide)
            wideOffsets()[line] = value;
        else
            narrowOffsets()[line] = static_cast<std::uint16_t>(value);
    }

private:
    static constexpr std::size_t segmentsAt(bool wide) noexcept {
        return sizeof(BlockHeader) +
               (wide ? (linesPerTile + 1) * sizeof(std::uint32_t) : (linesPerTile + 2) * sizeof(std::uint16_t));
    }
    std::byte* bytes() const noexcept { return reinterpret_cast<std::byte*>(header_); }
    std::uint16_t* narrowOffsets() const noexcept { return reinterpret_cast<std::uint16_t*>(header_ + 1); }
    std::uint32_t* wideOffsets() const noexcept { return reinterpret_cast<std::uint32_t*>(header_ + 1); }

    BlockHeader* header_;
};

} // namespace burin
