// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/occupied_bricks.h"

#include <algorithm>

namespace burin {

namespace {

std::size_t ceilingOf(std::int32_t count, std::int32_t side) noexcept {
    return static_cast<std::size_t>((count + side - 1) / side);
}

void include(OccupiedBricks::Extent& whole, OccupiedBricks::Extent part) noexcept {
    if (part.empty()) return;
    if (whole.empty()) {
        whole = part;
        return;
    }
    whole.low = std::min(whole.low, part.low);
    whole.high = std::max(whole.high, part.high);
}

OccupiedBricks::Extent extentOf(std::span<const Segment> line) noexcept {
    const bool airFirst = line.front().property() == airProperty, airLast = line.back().property() == airProperty;
    if (line.size() == 1 && airFirst) return {};
    const RunPosition low = airFirst ? line.front().end() : 0;
    const RunPosition high = airLast ? line[line.size() - 2].end() : line.back().end();
    return {static_cast<std::uint16_t>(low / unitsPerVoxel),
            static_cast<std::uint16_t>((high + unitsPerVoxel - 1) / unitsPerVoxel)};
}

} // namespace

OccupiedBricks::OccupiedBricks(const Grid& grid)
    : bricksU_(ceilingOf(grid.lineCountU(), brickSide))
    , blocksU_(ceilingOf(grid.lineCountU(), blockSide))
    , full_{0, static_cast<std::uint16_t>(grid.voxelsPerLine())}
    , bricks_(bricksU_ * ceilingOf(grid.lineCountV(), brickSide), full_)
    , blocks_(blocksU_ * ceilingOf(grid.lineCountV(), blockSide), full_) {}

void OccupiedBricks::forget() noexcept {
    std::ranges::fill(bricks_, full_);
    std::ranges::fill(blocks_, full_);
}

OccupiedBricks::Extent OccupiedBricks::lookAt(const RunVolume& volume, LineIndex line) noexcept {
    const Grid& grid = volume.grid();
    const LineIndex low{line.u - line.u % brickSide, line.v - line.v % brickSide};
    const LineIndex high{std::min(low.u + brickSide, grid.lineCountU()),
                         std::min(low.v + brickSide, grid.lineCountV())};
    Extent seen;
    for (LineIndex at{low.u, low.v}; at.v < high.v; ++at.v)
        for (at.u = low.u; at.u < high.u; ++at.u) include(seen, extentOf(volume.line(at)));
    Extent& brick = bricks_[brickAt(line)];
    const bool changed = seen.low != brick.low || seen.high != brick.high;
    brick = seen;
    if (!changed) return seen;

    const LineIndex first{line.u - line.u % blockSide, line.v - line.v % blockSide};
    Extent whole;
    for (LineIndex at{first.u, first.v}; at.v < std::min(first.v + blockSide, grid.lineCountV()); at.v += brickSide)
        for (at.u = first.u; at.u < std::min(first.u + blockSide, grid.lineCountU()); at.u += brickSide)
            include(whole, bricks_[brickAt(at)]);
    blocks_[blockAt(line)] = whole;
    return seen;
}

} // namespace burin
