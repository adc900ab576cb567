// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/packed/bit_stream.h"
#include "core/volume/packed/packed_prediction.h"
#include "core/volume/runs/brick_lines.h"
#include "core/volume/runs/run_volume.h"

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// What is needed to read a packed tile and is not stored in each.
struct PackedTileFrame {
    RunPosition lineEnd = 0;      ///< end of each scanline
    std::uint32_t properties = 1; ///< entries of the property list, air included
    friend bool operator==(const PackedTileFrame&, const PackedTileFrame&) = default;
};

/// Packs tiles without loss; volume_file.md describes the form. Scanlines with the same sequence of properties form a
/// group; each column of a group (the same run end on all its scanlines) is predicted by a constant, a plane or a
/// quadratic over the tile, and the residuals are stored at their exact width. Use one object per thread: it keeps its
/// working memory.
/// @throws std::bad_alloc
class TilePacker {
public:
    explicit TilePacker(const PackedTileFrame& frame) noexcept : frame_(frame) {}

    /// Appends the packed form of a tile, in whole bytes. The lines have to be gapless and end at the frame's line end,
    /// and neighbours have to differ in property. Cost: some µs for a tile of a few runs per line.
    void pack(const TileView& lines, std::string& bytes);

private:
    struct Group {
        std::array<std::uint8_t, linesPerTile> places{}; ///< indices of its scanlines
        std::size_t count = 0;
        std::span<const std::uint8_t> lines() const noexcept { return {places.data(), count}; }
    };
    /// How one column is stored.
    struct Column {
        Prediction prediction;
        bool relative = false;  ///< length since the previous end instead of the position
        unsigned width = 0;     ///< bits per residual
        std::uint64_t cost = 0; ///< bits
    };

    void findGroups(const TileView& lines);
    void findPalette(const TileView& lines);
    void writeSequence(std::span<const Segment> line, BitWriter& writer) const;
    void writeEnds(const TileView& lines, const Group& group, BitWriter& writer);
    static Column bestColumn(const TileView& lines, const Group& group, PredictionFit& fit, std::size_t column);
    void writeColumn(const TileView& lines, const Group& group, std::size_t place, BitWriter& writer) const;

    PackedTileFrame frame_;
    std::vector<Group> groups_;
    std::array<std::uint8_t, linesPerTile> groupOf_{};
    std::array<std::uint8_t, 256> ranks_{}; ///< rank of each property in the tile's palette
    std::vector<PropertyIndex> palette_;
    std::vector<Column> columns_;
};

/// Reads a packed tile at the start of `bytes`. False if they are damaged; `tile` is then complete but arbitrary. The
/// result is valid whatever the bytes are: gapless lines that end at the frame's line end.
/// Cost: 0.4–2 µs for a tile of a few runs per line; memory: never more than 64 segments per byte.
/// @param length  receives the number of bytes of the tile, if not null
/// @throws std::bad_alloc
bool unpackTile(std::string_view bytes, const PackedTileFrame& frame, BrickLines& tile, std::size_t* length = nullptr);

} // namespace burin
