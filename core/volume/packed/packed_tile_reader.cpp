// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/packed/packed_form.h"
#include "core/volume/packed/packed_tile.h"

#include <algorithm>
#include <cstddef>
#include <memory_resource>

namespace burin {

using namespace packed_form;

namespace {

/// Reads one tile part by part, in the order in which TilePacker writes them. Each part returns false if its content is
/// invalid.
class TileReader {
public:
    TileReader(std::string_view bytes, const PackedTileFrame& frame, BrickLines& tile) noexcept
        : reader_(bytes), frame_(frame), tile_(tile) {}

    bool read() {
        readPalette(palette_, frame_.properties, reader_);
        if (palette_.empty() || !readGroups() || !readSequences()) return false;
        placeLines();
        for (std::size_t group = 0; group < groupCount_; ++group)
            if (!readEnds(group)) return false;
        return reader_.good();
    }
    std::size_t length() const noexcept { return reader_.bytesRead(); }

private:
    bool readGroups();
    bool readSequences();
    bool readSequence(std::size_t group);
    void placeLines();
    bool readEnds(std::size_t group);
    bool readPlain(std::size_t group);
    bool readColumn(std::size_t group, std::size_t column);

    std::size_t columnsOf(std::size_t group) const noexcept {
        return sequenceEnds_[group + 1] - sequenceEnds_[group] - 1;
    }
    std::span<const PropertyIndex> sequence(std::size_t group) const noexcept {
        return std::span(sequences_).subspan(sequenceEnds_[group], columnsOf(group) + 1);
    }
    std::span<const std::uint8_t> lines(std::size_t group) const noexcept {
        return std::span(places_).subspan(placeEnds_[group], placeEnds_[group + 1] - placeEnds_[group]);
    }

    BitReader reader_;
    const PackedTileFrame frame_;
    BrickLines& tile_;
    Segment* segments_ = nullptr;            ///< of the tile
    const std::uint32_t* offsets_ = nullptr; ///< of the tile
    std::array<std::byte, 2048> scratch_;    ///< sufficient for ordinary tiles
    std::pmr::monotonic_buffer_resource memory_{scratch_.data(), scratch_.size()};
    std::pmr::vector<PropertyIndex> palette_{&memory_}, sequences_{&memory_};
    std::size_t groupCount_ = 0;
    std::array<std::uint8_t, linesPerTile> groupOf_{}, places_{};            ///< lines sorted by group
    std::array<std::size_t, linesPerTile + 1> placeEnds_{}, sequenceEnds_{}; ///< where each group's entries begin
};

bool TileReader::readGroups() {
    groupCount_ = std::size_t{reader_.getNumber()} + 1;
    if (groupCount_ > linesPerTile) return false;
    std::array<std::size_t, linesPerTile> counts{};
    const unsigned width = groupWidth(groupCount_);
    for (std::uint8_t& group : groupOf_) {
        group = static_cast<std::uint8_t>(reader_.get(width));
        if (group >= groupCount_) return false;
        ++counts[group];
    }
    for (std::size_t group = 0; group < groupCount_; ++group) placeEnds_[group + 1] = placeEnds_[group] + counts[group];
    auto next = placeEnds_;
    for (std::uint8_t i = 0; i < linesPerTile; ++i) places_[next[groupOf_[i]]++] = i;
    return std::ranges::find(counts.begin(), counts.begin() + static_cast<std::ptrdiff_t>(groupCount_),
                             std::size_t{0}) == counts.begin() + static_cast<std::ptrdiff_t>(groupCount_);
}

bool TileReader::readSequences() {
    std::uint64_t leastBits = 0;
    for (std::size_t group = 0; group < groupCount_; ++group) {
        if (!readSequence(group)) return false;
        leastBits += columnsOf(group) * std::min<std::uint64_t>(leastColumnBits, lines(group).size());
    }
    // Damaged bytes must not request memory that the remaining bytes could never fill.
    return reader_.holds(leastBits);
}

bool TileReader::readSequence(std::size_t group) {
    const std::uint64_t columns = reader_.getNumber();
    if (columns >= frame_.lineEnd || !reader_.holds(columns) || (columns > 0 && palette_.size() < 2)) return false;
    std::size_t rank = reader_.get(firstRankWidth(palette_.size()));
    if (rank >= palette_.size()) return false;
    sequences_.push_back(palette_[rank]);
    const unsigned width = nextRankWidth(palette_.size());
    for (std::uint64_t i = 0; i < columns; ++i) {
        const std::size_t next = reader_.get(width);
        rank = next >= rank ? next + 1 : next;
        if (rank >= palette_.size()) return false;
        sequences_.push_back(palette_[rank]);
    }
    sequenceEnds_[group + 1] = sequences_.size();
    return true;
}

void TileReader::placeLines() {
    std::size_t all = 0;
    for (const std::uint8_t group : groupOf_) all += columnsOf(group) + 1;
    tile_.writeAll(all, [&](Segment* segments, std::uint32_t* offsets) {
        std::uint32_t at = 0;
        for (std::size_t i = 0; i < linesPerTile; ++i) {
            offsets[i] = at;
            at += static_cast<std::uint32_t>(columnsOf(groupOf_[i]) + 1);
        }
        offsets[linesPerTile] = at;
        segments_ = segments;
        offsets_ = offsets;
    });
}

bool TileReader::readEnds(std::size_t group) {
    const std::size_t columns = columnsOf(group);
    const PropertyIndex last = sequence(group).back();
    for (const std::uint8_t place : lines(group)) segments_[offsets_[place] + columns] = Segment(frame_.lineEnd, last);
    if (columns == 0) return true;
    if (reader_.get(1) != 0) return readPlain(group);
    for (std::size_t column = 0; column < columns; ++column)
        if (!readColumn(group, column)) return false;
    return true;
}

bool TileReader::readPlain(std::size_t group) {
    const std::span<const PropertyIndex> properties = sequence(group);
    const std::size_t columns = columnsOf(group);
    const unsigned width = reader_.get(widthWidth);
    if (width == 0 || !reader_.holds(std::uint64_t{width} * columns * lines(group).size())) return false;
    for (const std::uint8_t place : lines(group)) {
        Segment* next = segments_ + offsets_[place];
        std::uint64_t end = 0;
        for (std::size_t column = 0; column < columns; ++column) {
            end += std::uint64_t{reader_.get(width)} + 1;
            if (end >= frame_.lineEnd) return false;
            *next++ = Segment(static_cast<RunPosition>(end), properties[column]);
        }
    }
    return true;
}

bool TileReader::readColumn(std::size_t group, std::size_t column) {
    Prediction prediction;
    const std::uint32_t shape = reader_.get(shapeWidth);
    if (shape > static_cast<std::uint32_t>(PredictionShape::quadratic)) return false;
    prediction.shape = static_cast<PredictionShape>(shape);
    const bool relative = column > 0 && reader_.get(1) != 0;
    const unsigned width = reader_.get(widthWidth);
    readCoefficients(prediction, reader_);
    const std::span<const std::uint8_t> places = lines(group);
    if (!reader_.holds(std::uint64_t{width} * places.size())) return false;
    TileValues values;
    prediction.evaluate(values);
    if (width > 0)
        for (const std::uint8_t place : places) values[place] += reader_.get(width);
    const PropertyIndex property = sequence(group)[column];
    const RunPosition lineEnd = frame_.lineEnd;
    bool sound = true;
    for (const std::uint8_t place : places) {
        Segment* const segment = segments_ + offsets_[place] + column;
        const RunPosition before = column > 0 ? segment[-1].end() : 0;
        const RunPosition end = (values[place] & predictionMask) + (relative ? before : 0);
        sound &= (end > before) & (end < lineEnd);
        *segment = Segment(end, property);
    }
    return sound;
}

} // namespace

bool unpackTile(std::string_view bytes, const PackedTileFrame& frame, BrickLines& tile, std::size_t* length) {
    TileReader reader(bytes, frame, tile);
    if (!reader.read()) return false;
    if (length != nullptr) *length = reader.length();
    return true;
}

} // namespace burin
