// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/runs/alike.h"
#include "core/volume/runs/volume_access.h"
#include "core/volume/surface/surface.h"
#include "core/volume/surface/surface_window.h"

#include <algorithm>
#include <tuple>

namespace burin {

namespace {

/// Calls visit(line, before, now) for the bricks of 8 × 8 scanlines that two snapshots of one volume do not share, with
/// the first `line` of each. Shared pages of the table are skipped as a whole.
template <class Visit>
void eachChangedBrick(const VolumeSnapshot& before, const VolumeSnapshot& now, Visit visit) {
    const VolumeState &old = VolumeAccess::state(before), &fresh = VolumeAccess::state(now);
    const VolumeStore& store = *fresh.store;
    const TileTable& table = store.table;
    for (std::size_t page = 0; page < table.pageCount(); ++page) {
        if (old.pages[page] == fresh.pages[page]) continue;
        const std::span<const BlockIndex> oldTiles = store.page(old.pages[page]), tiles = store.page(fresh.pages[page]);
        const auto pageU = static_cast<std::int32_t>(page) % table.pagesU,
                   pageV = static_cast<std::int32_t>(page) / table.pagesU;
        for (std::size_t entry = 0; entry < tiles.size(); ++entry) {
            if (oldTiles[entry] == tiles[entry]) continue;
            const auto at = static_cast<std::int32_t>(entry);
            const std::int32_t u = pageU * TileTable::pageSide + at % TileTable::pageSide;
            const std::int32_t v = pageV * TileTable::pageSide + at / TileTable::pageSide;
            if (u < table.tilesU && v < table.tilesV)
                visit(LineIndex{u * tileSide, v * tileSide}, store.tile(oldTiles[entry]), store.tile(tiles[entry]));
        }
    }
}

/// The same for two volumes on one grid, compared by the content of their bricks.
template <class Visit>
void eachOtherBrick(const VolumeSnapshot& before, const VolumeSnapshot& now, Visit visit) {
    for (LineIndex line{0, 0}; line.v < now.grid().lineCountV(); line.v += tileSide)
        for (line.u = 0; line.u < now.grid().lineCountU(); line.u += tileSide)
            if (!std::ranges::equal(before.brick(line), now.brick(line))) visit(line);
}

/// The surface tiles of the lines within `reach` of a brick of scanlines.
struct TilesAround {
    glm::ivec2 low, high;
    TilesAround(LineIndex line, std::int32_t reach, const glm::ivec2& count)
        : low(glm::max(glm::ivec2(line.u, line.v) - reach, 0) / linesPerSurfaceTile)
        , high(glm::min((glm::ivec2(line.u, line.v) + tileSide - 1 + reach) / linesPerSurfaceTile, count - 1)) {}
    template <class Visit>
    void each(Visit visit) const {
        for (int v = low.y; v <= high.y; ++v)
            for (int u = low.x; u <= high.x; ++u) visit(SurfaceTile{u, v});
    }
};

/// The interval of a line outside which two states of it are equal; empty if they are equal everywhere.
struct ChangedInterval {
    RunPosition from = 0, to = 0;
    ChangedInterval(std::span<const Segment> before, std::span<const Segment> now) {
        const auto [old, fresh] = std::ranges::mismatch(before, now);
        if (fresh == now.end()) return;
        from = old->property() == fresh->property() ? std::min(old->end(), fresh->end()) : beginOf(now, fresh);
        auto lastOld = before.end() - 1, lastFresh = now.end() - 1;
        while (lastOld->property() == lastFresh->property() && beginOf(before, lastOld) == beginOf(now, lastFresh)) {
            --lastOld;
            --lastFresh;
        }
        to = lastOld->property() == lastFresh->property() ? std::max(beginOf(before, lastOld), beginOf(now, lastFresh))
                                                          : lastFresh->end();
    }
    bool empty() const { return from == to; }

private:
    static RunPosition beginOf(std::span<const Segment> line, std::span<const Segment>::iterator segment) {
        return segment == line.begin() ? 0 : segment[-1].end();
    }
};

} // namespace

std::vector<SurfaceTile> changedSurface(const VolumeSnapshot& before, const VolumeSnapshot& now, int level) {
    const glm::ivec2 count = surfaceTiles(now.grid());
    const bool same = now.sameVolume(before);
    const bool known = same || (!before.empty() && alike(before.grid(), now.grid()));
    std::vector<std::uint8_t> changed(static_cast<std::size_t>(count.x) * static_cast<std::size_t>(count.y),
                                      known ? 0 : 1);
    const auto place = [&](SurfaceTile tile) { return static_cast<std::size_t>(tile.v * count.x + tile.u); };
    const auto mark = [&](LineIndex line) {
        TilesAround(line, SurfaceWindow::margin << level, count).each([&](SurfaceTile tile) {
            changed[place(tile)] = 1;
        });
    };
    if (same)
        eachChangedBrick(before, now, [&](LineIndex line, Tile, Tile) { mark(line); });
    else if (known)
        eachOtherBrick(before, now, mark);
    std::vector<SurfaceTile> tiles;
    for (int v = 0; v < count.y; ++v)
        for (int u = 0; u < count.x; ++u)
            if (changed[place({u, v})] != 0) tiles.push_back({u, v});
    return tiles;
}

void changedSurfaceBricks(const VolumeSnapshot& before, const VolumeSnapshot& now, std::vector<SurfaceBrick>& bricks) {
    const Grid& grid = now.grid();
    const glm::ivec2 count = surfaceTiles(grid);
    const int pieces = SurfaceWindow::count(grid, 0);
    bricks.clear();
    if (!now.sameVolume(before)) {
        for (int v = 0; v < count.y; ++v)
            for (int u = 0; u < count.x; ++u)
                for (int n = 0; n < pieces; ++n) bricks.push_back({u, v, n});
        return;
    }
    // How far a window sees beyond its own nodes.
    constexpr auto reach = static_cast<std::int32_t>((SurfaceWindow::marginNodes + 1) * unitsPerVoxel);
    constexpr auto length = static_cast<std::int32_t>(SurfaceWindow::ownedNodes * unitsPerVoxel);
    std::vector<std::uint8_t> marks(static_cast<std::size_t>(pieces));
    eachChangedBrick(before, now, [&](LineIndex line, Tile old, Tile fresh) {
        std::ranges::fill(marks, std::uint8_t{0});
        int first = pieces, last = -1;
        for (int i = 0; i < linesPerTile; ++i) {
            if (!grid.contains(LineIndex{line.u + i % tileSide, line.v + i / tileSide})) continue;
            const ChangedInterval interval(old.line(i), fresh.line(i));
            if (interval.empty()) continue;
            const int from = std::max((static_cast<std::int32_t>(interval.from) - reach) / length, 0);
            const int to = std::min((static_cast<std::int32_t>(interval.to) + reach) / length, pieces - 1);
            std::fill(marks.begin() + from, marks.begin() + to + 1, std::uint8_t{1});
            first = std::min(first, from);
            last = std::max(last, to);
        }
        TilesAround(line, SurfaceWindow::margin, count).each([&](SurfaceTile tile) {
            for (int n = first; n <= last; ++n)
                if (marks[static_cast<std::size_t>(n)] != 0) bricks.push_back({tile.u, tile.v, n});
        });
    });
    const auto key = [](const SurfaceBrick& brick) { return std::tuple(brick.v, brick.u, brick.n); };
    std::ranges::sort(bricks, {}, key);
    bricks.erase(std::ranges::unique(bricks).begin(), bricks.end());
}

} // namespace burin
