// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/surface/surface_field.h"

#include "core/volume/surface/surface_lanes.h"

#include <algorithm>

namespace burin {

namespace {

constexpr std::int16_t cell = SurfaceLine::cell, centre = SurfaceLine::centre;

/// The columns of a row: their number, and the number of nodes of each, in whole lanes.
struct Columns {
    int count = 0, stride = 0;
};

/// Centres of sixteen nodes.
BURIN_INLINE Nodes centresFrom(int node) noexcept {
    const Nodes steps{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
    return (steps + static_cast<std::int16_t>(node)) * cell + centre;
}
/// Contribution of a change to material at `place` to the nodes: negative where there is mostly air, 256 in the middle
/// of material.
BURIN_INLINE Nodes seen(Nodes centres, std::int16_t place) noexcept {
    const Nodes beyond = centres - place, most = nodes(cell), least = nodes(-cell);
    const Nodes held = beyond < most ? beyond : most;
    return held > least ? held : least;
}
BURIN_INLINE Nodes seen(Nodes centres, SurfaceLine line) noexcept {
    return (seen(centres, line.place) ^ line.toAir) - line.toAir; // inverted if material ends there
}

/// Sums over the scanlines of each column, if there are many.
/// @param step  from a scanline to the next along v
BURIN_VECTORISED void addLines(const SurfaceLine* lines, std::size_t step, Columns columns, int level, int firstNode,
                               std::int16_t* nodes) noexcept {
    for (int n = 0; n < columns.stride; n += nodeLanes) {
        const Nodes centres = centresFrom(firstNode + n);
        for (int column = 0; column < columns.count; ++column) {
            Nodes sum{};
            for (std::size_t v = 0; v < std::size_t{1} << level; ++v) {
                const SurfaceLine* const first = lines + v * step + (column << level);
                for (int u = 0; u < 1 << level; ++u) sum += seen(centres, first[u]);
            }
            storeNodes(sum, nodes + column * columns.stride + n);
        }
    }
}

/// Adds the contributions of changes behind the first one of a scanline.
BURIN_VECTORISED void addFurther(const SurfaceLines::Further* further, std::size_t count, int firstColumn, int stride,
                                 int firstNode, std::int16_t* nodes) noexcept {
    for (std::size_t i = 0; i < count; ++i) {
        std::int16_t* const column = nodes + (further[i].column - firstColumn) * stride;
        const std::int16_t toAir = further[i].line.toAir;
        for (int n = 0; n < stride; n += nodeLanes) {
            const Nodes more = seen(centresFrom(firstNode + n), further[i].line.place) + cell;
            storeNodes(loadNodes(column + n) + ((more ^ toAir) - toAir), column + n);
        }
    }
}

/// Converts sums over the scanlines of a cell to their mean.
BURIN_VECTORISED void takeMean(Columns columns, int level, std::int16_t* nodes) noexcept {
    const auto half = static_cast<std::int16_t>(1 << (2 * level) >> 1);
    for (int i = 0; i < columns.count * columns.stride; i += nodeLanes)
        storeNodes((loadNodes(nodes + i) + half) >> (2 * level), nodes + i);
}

/// Destinations of a row's averages. Two rows of each kind are kept; the newest replaces the one two before it.
struct Averaging {
    std::int16_t *alongU, *values; ///< of the newest row; of the one before
    const std::int16_t* alongUBefore;
    std::uint64_t* below;                           ///< likewise
    std::int16_t *acrossRuns, *alongNodes, *smooth; ///< of that row; of that row; of the one before that
    const std::int16_t* alongNodesBefore;
};

/// 1-2-1.
BURIN_INLINE Nodes average(Nodes before, Nodes middle, Nodes behind) noexcept {
    return (before + middle) + (middle + behind);
}

/// Columns 1 … count - 2 of `values` and `below`, 2 … count - 3 of `acrossRuns`.
/// @param seenIn  values of the nodes of a column
template <class Column>
BURIN_INLINE void averageAcross(const Averaging& row, Columns columns, int n, Column seenIn) noexcept {
    const int stride = columns.stride;
    Nodes at = seenIn(1), pair = seenIn(0) + at;
    Nodes value{}, valuePair{};
    for (int column = 1, place = stride + n; column < columns.count - 1; ++column, place += stride) {
        const Nodes next = seenIn(column + 1), nextPair = at + next;
        const Nodes alongU = pair + nextPair;
        const Nodes nextValue = average(loadNodes(row.alongU + place), loadNodes(row.alongUBefore + place), alongU);
        const Nodes nextValuePair = value + nextValue;
        storeNodes(alongU, row.alongU + place);
        storeNodes(nextValue, row.values + place);
        storeNodes((valuePair + nextValuePair) >> 2, row.acrossRuns + place - stride);
        row.below[column] |= negative(nextValue) << n;
        at = next;
        pair = nextPair;
        value = nextValue;
        valuePair = nextValuePair;
    }
}

BURIN_INLINE void averageAlong(const Averaging& row, Columns columns) noexcept {
    for (int i = 2 * columns.stride; i < (columns.count - 2) * columns.stride; i += nodeLanes) {
        const Nodes alongNodes = average(loadNodes(row.acrossRuns + i - 1), loadNodes(row.acrossRuns + i),
                                         loadNodes(row.acrossRuns + i + 1)) >>
                                 2;
        storeNodes(average(loadNodes(row.alongNodes + i), loadNodes(row.alongNodesBefore + i), alongNodes),
                   row.smooth + i);
        storeNodes(alongNodes, row.alongNodes + i);
    }
}

/// For a row whose columns have one scanline each, with at most one change.
BURIN_VECTORISED void averageLines(const Averaging& row, Columns columns, const SurfaceLine* lines,
                                   int firstNode) noexcept {
    for (int column = 0; column < columns.count; ++column) row.below[column] = 0;
    for (int n = 0; n < columns.stride; n += nodeLanes) {
        const Nodes centres = centresFrom(firstNode + n);
        averageAcross(row, columns, n, [&](int column) noexcept { return seen(centres, lines[column]); });
    }
    averageAlong(row, columns);
}

BURIN_VECTORISED void averageNodes(const Averaging& row, Columns columns, const std::int16_t* nodes) noexcept {
    for (int column = 0; column < columns.count; ++column) row.below[column] = 0;
    for (int n = 0; n < columns.stride; n += nodeLanes)
        averageAcross(row, columns, n,
                      [&](int column) noexcept { return loadNodes(nodes + column * columns.stride + n); });
    averageAlong(row, columns);
}

} // namespace

void SurfaceField::start(const SurfaceWindow& window, const SurfaceLines& lines) {
    window_ = &window;
    lines_ = &lines;
    row_ = lines.box().rows.first;
    stride_ = (lines.box().nodes.count + nodeLanes - 1) / nodeLanes * nodeLanes;
}

void SurfaceField::advance() {
    const SurfaceBox& box = lines_->box();
    const Columns columns{box.columns.count, stride_};
    const int level = window_->level, firstNode = box.nodes.first;
    const SurfaceLine* const lines = lines_->at(row_, box.columns.first);
    const std::span<const SurfaceLines::Further> further = lines_->further(row_);
    // In the first rows, values derived from rows before the box are overwritten before they are read.
    const auto before = static_cast<std::size_t>(row_ + 5), newest = before % 2;
    const Averaging row{
        alongU_[newest].data(), values_[before % 3].data(), alongU_[1 - newest].data(), below_[before % 3].data(),
        acrossRuns_.data(),     alongNodes_[newest].data(), smooth_[1 - newest].data(), alongNodes_[1 - newest].data()};
    if (level == 0 && further.empty()) {
        averageLines(row, columns, lines, firstNode);
    } else {
        addLines(lines, lines_->step(), columns, level, firstNode, seen_.data());
        if (!further.empty())
            addFurther(further.data(), further.size(), box.columns.first, stride_, firstNode, seen_.data());
        if (level != 0) takeMean(columns, level, seen_.data());
        averageNodes(row, columns, seen_.data());
    }
    ++row_;
    rowPair_ = {rowAt(row_ - delay), rowAt(row_ - delay + 1)};
}

} // namespace burin
