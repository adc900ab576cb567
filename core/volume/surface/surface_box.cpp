// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/surface/surface_box.h"

#include "core/volume/surface/surface_lanes.h"

#include <algorithm>
#include <array>

namespace burin {

namespace {

constexpr std::int16_t beyond = SurfaceLine::beyond;
/// Of a row; the same for rows.
constexpr std::size_t mostLines = linesPerSurfaceTile + (2 * SurfaceWindow::margin << coarsestSurfaceLevel);
static_assert(sizeof(SurfaceLine) * surfaceLineLanes == sizeof(Nodes) && mostLines % surfaceLineLanes == 0);

/// Range of the first changes of some lines. Lines without a change are all air or all solid if both bounds are equal.
struct Extent {
    std::int16_t least, most;
    void add(const Extent& other) {
        least = std::min(least, other.least);
        most = std::max(most, other.most);
    }
    bool uniform() const { return least == most && (least == beyond || least == -beyond); }
    friend bool operator==(const Extent&, const Extent&) = default;
};
constexpr Extent nothing{beyond, -beyond};

struct Extents {
    std::array<Extent, mostLines> byRow, byLine; ///< by row of scanlines, and by scanline of a row
    Extent changes;                              ///< range of all changes
};

/// For eight lines side by side. (Between the positions are the directions of change, which do not matter here.)
struct EightExtents {
    Nodes least = nodes(beyond), most = nodes(-beyond);
};
BURIN_INLINE void add(Nodes low, Nodes high, EightExtents& to) noexcept {
    to.least = low < to.least ? low : to.least;
    to.most = high > to.most ? high : to.most;
}
BURIN_INLINE Extent ofAll(const EightExtents& eight) noexcept {
    Nodes least = eight.least, most = eight.most;
    const auto add = [&](Nodes otherLeast, Nodes otherMost) noexcept {
        least = otherLeast < least ? otherLeast : least;
        most = otherMost > most ? otherMost : most;
    };
    // Swaps lanes at even distances, so that positions are combined only with positions.
    add(__builtin_shufflevector(least, least, 8, 9, 10, 11, 12, 13, 14, 15, 0, 1, 2, 3, 4, 5, 6, 7),
        __builtin_shufflevector(most, most, 8, 9, 10, 11, 12, 13, 14, 15, 0, 1, 2, 3, 4, 5, 6, 7));
    add(__builtin_shufflevector(least, least, 4, 5, 6, 7, 0, 1, 2, 3, 12, 13, 14, 15, 8, 9, 10, 11),
        __builtin_shufflevector(most, most, 4, 5, 6, 7, 0, 1, 2, 3, 12, 13, 14, 15, 8, 9, 10, 11));
    add(__builtin_shufflevector(least, least, 2, 3, 0, 1, 6, 7, 4, 5, 10, 11, 8, 9, 14, 15, 12, 13),
        __builtin_shufflevector(most, most, 2, 3, 0, 1, 6, 7, 4, 5, 10, 11, 8, 9, 14, 15, 12, 13));
    return {least[0], most[0]};
}

BURIN_VECTORISED void findExtents(const SurfaceLine* lines, std::size_t step, std::size_t rows,
                                  Extents& extents) noexcept {
    std::array<EightExtents, mostLines / surfaceLineLanes> columns;
    EightExtents changes;
    const Nodes air = nodes(beyond), solid = nodes(-beyond);
    for (std::size_t row = 0; row < rows; ++row) {
        EightExtents whole;
        for (std::size_t i = 0; i < step / surfaceLineLanes; ++i) {
            const Nodes here = loadNodes(&lines[row * step + i * surfaceLineLanes].place);
            add(here, here, columns[i]);
            add(here, here, whole);
            add(here == solid ? air : here, here == air ? solid : here, changes);
        }
        extents.byRow[row] = ofAll(whole);
    }
    extents.changes = ofAll(changes);
    for (std::size_t line = 0; line < step; ++line) {
        const EightExtents& eight = columns[line / surfaceLineLanes];
        const auto lane = static_cast<int>(2 * (line % surfaceLineLanes));
        extents.byLine[line] = {eight.least[lane], eight.most[lane]};
    }
}

/// Excludes columns (rows) that are completely air or solid, as long as they equal the outermost one on their side.
/// Averages reach one column and those for normals two: a column beside one that changes has values other than all air
/// and all solid, but the same sign.
SurfaceBox::Range withoutUniform(std::span<const Extent> lines, int level) {
    constexpr int reach = SurfaceWindow::margin;
    std::array<Extent, SurfaceWindow::mostColumns> extents;
    extents.fill(nothing);
    for (std::size_t i = 0; i < lines.size(); ++i) extents[i >> level].add(lines[i]);
    const auto count = static_cast<int>(lines.size() >> level);
    const auto begin = extents.begin(), end = begin + count;
    const auto differsFrom = [](const Extent& outermost) {
        return [&outermost](const Extent& one) { return !one.uniform() || !(one == outermost); };
    };
    const auto low = std::find_if(begin, end, differsFrom(*begin));
    if (low == end) return {};
    auto high = end;
    while (!differsFrom(end[-1])(high[-1])) --high;
    const int first = std::max(static_cast<int>(low - begin) - reach, 0);
    return {first, std::min(static_cast<int>(high - begin) + reach, count) - first};
}

/// Quotients rounded down and up.
constexpr int floorQuotient(int value, int divisor) {
    return value >= 0 ? value / divisor : -((divisor - 1 - value) / divisor);
}
constexpr int ceilingQuotient(int value, int divisor) {
    return -floorQuotient(-value, divisor);
}

/// Nodes that are neither all air nor all solid are less than a cell away from a change.
SurfaceBox::Range nodesBetween(const SurfaceWindow& window, const Extent& changes, bool differAtBegin,
                               bool differAtEnd) {
    constexpr int reach = SurfaceWindow::marginNodes, cell = SurfaceLine::cell, centre = SurfaceLine::centre;
    int first = floorQuotient(changes.least - cell - centre, cell) + 1;
    int end = ceilingQuotient(changes.most + centre, cell);
    if (differAtBegin) first = 0;
    if (differAtEnd) end = window.nodes();
    first = std::max(first, reach) - reach;
    end = std::min(end, window.nodes() - reach) + reach;
    if (end - first < 2 * reach) return {}; // no cube between them is the window's own
    return {first, end - first};
}

} // namespace

SurfaceBox findSurfaceBox(const SurfaceWindow& window, const SurfaceChanges& changes,
                          std::span<const SurfaceLine> lines) {
    const std::size_t rows = static_cast<std::size_t>(window.rows) << window.level;
    const std::size_t columns = static_cast<std::size_t>(window.columns) << window.level;
    Extents extents;
    findExtents(lines.data(), lines.size() / rows, rows, extents);
    extents.changes.add({changes.lowest, changes.highest});
    SurfaceBox box;
    box.nodes = nodesBetween(window, extents.changes, changes.atBegin == 3, changes.atEnd == 3);
    if (box.nodes.count == 0) return box;
    box.rows = withoutUniform(std::span(extents.byRow).first(rows), window.level);
    box.columns = withoutUniform(std::span(extents.byLine).first(columns), window.level);
    return box;
}

} // namespace burin
