// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/packed/packed_tile.h"

#include "core/volume/packed/packed_form.h"

#include <algorithm>
#include <bit>

namespace burin {

using namespace packed_form;

namespace {

bool sameSequence(std::span<const Segment> a, std::span<const Segment> b) noexcept {
    return std::ranges::equal(a, b, {}, &Segment::property, &Segment::property);
}

/// The run ends of one column, or the lengths up to them, by index in the tile.
void valuesOf(const TileView& lines, std::span<const std::uint8_t> places, std::size_t column, bool relative,
              TileValues& values) noexcept {
    for (const std::uint8_t place : places) {
        const Segment* const segment = lines[place].data() + column;
        values[place] = segment->end() - (relative ? segment[-1].end() : 0);
    }
}

/// Bits of the longest length between two ends minus one, over all scanlines of a group; at least 1.
unsigned plainWidth(const TileView& lines, std::span<const std::uint8_t> places) noexcept {
    std::uint32_t any = 1;
    for (const std::uint8_t place : places) {
        RunPosition start = 0;
        for (const Segment segment : lines[place].first(lines[place].size() - 1)) {
            any |= segment.end() - start - 1;
            start = segment.end();
        }
    }
    return static_cast<unsigned>(std::bit_width(any));
}

} // namespace

void TilePacker::findGroups(const TileView& lines) {
    groups_.clear();
    for (std::size_t i = 0; i < lines.size(); ++i) {
        std::size_t group = i > 0 && sameSequence(lines[i], lines[i - 1]) ? groupOf_[i - 1] : 0;
        if (i > 0 && group == 0)
            while (group < groups_.size() && !sameSequence(lines[i], lines[groups_[group].places[0]])) ++group;
        if (group == groups_.size()) groups_.emplace_back();
        groups_[group].places[groups_[group].count++] = static_cast<std::uint8_t>(i);
        groupOf_[i] = static_cast<std::uint8_t>(group);
    }
}

void TilePacker::findPalette(const TileView& lines) {
    std::array<bool, 256> present{};
    for (const Group& group : groups_)
        for (const Segment segment : lines[group.places[0]]) present[segment.property()] = true;
    palette_.clear();
    for (std::size_t i = 0; i < present.size(); ++i) {
        ranks_[i] = static_cast<std::uint8_t>(palette_.size());
        if (present[i]) palette_.push_back(static_cast<PropertyIndex>(i));
    }
}

void TilePacker::writeSequence(std::span<const Segment> line, BitWriter& writer) const {
    writer.putNumber(static_cast<std::uint32_t>(line.size() - 1));
    std::uint32_t before = ranks_[line[0].property()];
    writer.put(before, firstRankWidth(palette_.size()));
    for (const Segment segment : line.subspan(1)) {
        const std::uint32_t rank = ranks_[segment.property()];
        writer.put(rank > before ? rank - 1 : rank, nextRankWidth(palette_.size()));
        before = rank;
    }
}

TilePacker::Column TilePacker::bestColumn(const TileView& lines, const Group& group, PredictionFit& fit,
                                          std::size_t column) {
    TileValues values{};
    Column best;
    best.cost = ~std::uint64_t{0};
    for (const bool relative : {false, true}) {
        if (relative && column == 0) break;
        valuesOf(lines, group.lines(), column, relative, values);
        fit.set(values);
        for (const PredictionShape shape :
             {PredictionShape::constant, PredictionShape::plane, PredictionShape::quadratic}) {
            Column next;
            next.relative = relative;
            if (!fit.fit(shape, next.prediction, next.width)) break;
            next.cost =
                columnHeadBits(column) + coefficientBits(next.prediction) + std::uint64_t{next.width} * group.count;
            if (next.cost < best.cost) best = next;
            if (next.width == 0) break;
        }
    }
    return best;
}

void TilePacker::writeColumn(const TileView& lines, const Group& group, std::size_t place, BitWriter& writer) const {
    const Column& column = columns_[place];
    writer.put(static_cast<std::uint32_t>(column.prediction.shape), shapeWidth);
    if (place > 0) writer.put(column.relative ? 1 : 0, 1);
    writer.put(column.width, widthWidth);
    writeCoefficients(column.prediction, writer);
    if (column.width == 0) return;
    TileValues values, expected;
    valuesOf(lines, group.lines(), place, column.relative, values);
    column.prediction.evaluate(expected);
    for (const std::uint8_t line : group.lines())
        writer.put((values[line] - expected[line]) & predictionMask, column.width);
}

void TilePacker::writeEnds(const TileView& lines, const Group& group, BitWriter& writer) {
    const std::size_t columns = lines[group.places[0]].size() - 1;
    if (columns == 0) return;
    const unsigned width = plainWidth(lines, group.lines());
    const std::uint64_t plainCost = widthWidth + std::uint64_t{width} * columns * group.count;
    PredictionFit fit(group.lines());
    columns_.clear();
    std::uint64_t cost = 0;
    while (columns_.size() < columns && cost < plainCost) {
        columns_.push_back(bestColumn(lines, group, fit, columns_.size()));
        cost += columns_.back().cost;
    }
    const bool plain = plainCost <= cost;
    writer.put(plain ? 1 : 0, 1);
    if (!plain) {
        for (std::size_t place = 0; place < columns; ++place) writeColumn(lines, group, place, writer);
        return;
    }
    writer.put(width, widthWidth);
    for (const std::uint8_t place : group.lines()) {
        RunPosition start = 0;
        for (const Segment segment : lines[place].first(columns)) {
            writer.put(segment.end() - start - 1, width);
            start = segment.end();
        }
    }
}

void TilePacker::pack(const TileView& lines, std::string& bytes) {
    findGroups(lines);
    findPalette(lines);
    BitWriter writer(bytes);
    writePalette(palette_, frame_.properties, writer);
    writer.putNumber(static_cast<std::uint32_t>(groups_.size() - 1));
    if (groups_.size() > 1)
        for (const std::uint8_t group : groupOf_) writer.put(group, groupWidth(groups_.size()));
    for (const Group& group : groups_) writeSequence(lines[group.places[0]], writer);
    for (const Group& group : groups_) writeEnds(lines, group, writer);
    writer.finish();
}

} // namespace burin
