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

/// What a packed tile is read with: it is not stored in each.
struct PackedTileFrame {
    RunPosition lineEnd = 0;      ///< each scanline ends there
    std::uint32_t properties = 1; ///< entries of the property list, air included
    friend bool operator==(const PackedTileFrame&, const PackedTileFrame&) = default;
};

/// Packs tiles without loss; volume_file.md gives the form. Scanlines with one sequence of properties form a group;
/// each column of a group (the same run end on all its scanlines) is predicted by a constant, a plane or a quadratic
/// over the tile, and what is left is stored at its exact width. One object a thread: it keeps its working memory.
/// @throws std::bad_alloc
class TilePacker {
public:
    explicit TilePacker(const PackedTileFrame& frame) noexcept : frame_(frame) {}

    /// Appends the packed form of a tile, whole bytes. The lines have to be gapless and end at the frame's line end,
    /// neighbours differ in property. Cost: some µs for a tile of a few runs a line.
    void pack(const TileView& lines, std::string& bytes);

private:
    struct Group {
        std::array<std::uint8_t, linesPerTile> places{}; ///< of its scanlines
        std::size_t count = 0;
        std::span<const std::uint8_t> lines() const noexcept { return {places.data(), count}; }
    };
    /// How one column is stored.
    struct Column {
        Prediction prediction;
        bool relative = false;  ///< the length since the end before, not the place
        unsigned width = 0;     ///< bits of what is left
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
    std::array<std::uint8_t, 256> ranks_{}; ///< of each property in the tile's palette
    std::vector<PropertyIndex> palette_;
    std::vector<Column> columns_;
};

/// Reads a packed tile at the start of `bytes`. False: they are damaged; `tile` is complete, and anything, then.
/// What is read is sound whatever the bytes are: gapless lines that end at the frame's line end.
/// Cost: 0.4–2 µs for a tile of a few runs a line; memory: never more than 64 segments a byte.
/// @param length bytes that the tile takes, where it is asked for
/// @throws std::bad_alloc
bool unpackTile(std::string_view bytes, const PackedTileFrame& frame, BrickLines& tile, std::size_t* length = nullptr);

} // namespace burin
