// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/surface/surface_search.h"

#include <algorithm>

namespace burin {

std::span<const int> SurfaceSearch::pieces(const VolumeSnapshot& workpiece, SurfaceTile tile, int level) {
    const Grid& grid = workpiece.grid();
    const auto count = static_cast<std::size_t>(SurfaceWindow::count(grid, level));
    cell_ = std::int64_t{unitsPerVoxel} << level;
    solid_.assign(count + 1, 0);
    air_.assign(count + 1, 0);
    const SurfaceWindow window = SurfaceWindow::of(grid, tile, 0, level);
    const LineIndex low{window.firstU << level, window.firstV << level};
    const LineIndex high{low.u + (window.columns << level), low.v + (window.rows << level)};
    if (!grid.contains(low) || high.u > grid.lineCountU() || high.v > grid.lineCountV()) ++air_[0];
    for (std::int32_t v = std::max(low.v, 0); v < std::min(high.v, grid.lineCountV()); ++v)
        for (std::int32_t u = std::max(low.u, 0); u < std::min(high.u, grid.lineCountU()); ++u)
            mark(workpiece.line({u, v}), grid.lineEnd());
    found_.clear();
    int solid = 0, air = 0;
    for (std::size_t piece = 0; piece < count; ++piece) {
        solid += solid_[piece];
        air += air_[piece];
        if (solid > 0 && air > 0) found_.push_back(static_cast<int>(piece));
    }
    return found_;
}

void SurfaceSearch::mark(std::span<const Segment> line, RunPosition lineEnd) {
    constexpr std::int64_t far = std::int64_t{1} << 40; // beyond the grid everything is air
    std::int64_t from = -far;
    bool solid = false;
    RunPosition begin = 0;
    for (const Segment segment : line) {
        if ((segment.property() != airProperty) != solid) {
            markInterval(solid ? solid_ : air_, from, begin);
            from = begin;
            solid = !solid;
        }
        begin = segment.end();
    }
    if (solid) {
        markInterval(solid_, from, lineEnd);
        from = lineEnd;
    }
    markInterval(air_, from, far);
}

void SurfaceSearch::markInterval(std::vector<int>& steps, std::int64_t from, std::int64_t to) const {
    constexpr std::int64_t reach = SurfaceWindow::marginNodes + 1; // how far a window's nodes see beyond its own
    const std::int64_t piece = SurfaceWindow::ownedNodes * cell_, last = static_cast<std::int64_t>(steps.size()) - 1;
    const auto place = [&](std::int64_t position) {
        return static_cast<std::size_t>(std::clamp<std::int64_t>(position / piece, 0, last)); // also below 0
    };
    ++steps[place(from - reach * cell_)];
    --steps[place(to + reach * cell_ + piece)];
}

} // namespace burin
