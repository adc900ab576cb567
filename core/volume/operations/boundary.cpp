// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/operations/boundary.h"

#include "core/base/parallel.h"
#include "core/volume/operations/voxel_places.h"
#include "core/volume/runs/volume_access.h"

#include <numeric>

namespace burin {

namespace {

/// Calls visit(VoxelInterval) for the boundary voxels of a line.
/// @param own     intervals where the line holds material
/// @param common  intervals where the line and all eight lines around it hold material. A voxel is not on the boundary
///        if all nine are full from the voxel before to the one after: all voxels of these intervals except the first
///        and the last of each.
template <class Visit>
void eachBoundaryInterval(VoxelPlaces own, VoxelPlaces common, Visit&& visit) {
    std::size_t inner = 0;
    for (std::size_t i = 0; i < own.size(); i += 2) {
        std::int32_t from = own[i];
        for (; inner < common.size() && common[inner] < own[i + 1]; inner += 2) {
            if (common[inner] + 1 >= common[inner + 1] - 1) continue;
            visit(VoxelInterval{from, common[inner]});
            from = common[inner + 1] - 1;
        }
        visit(VoxelInterval{from, own[i + 1] - 1});
    }
}

} // namespace

/// The material of the lines of one brick and of the neighbouring rows along v. Lines with at most one interval, which
/// most are, are also stored in arrays, to be processed at once.
class BoundaryList::Surrounding {
public:
    static constexpr std::size_t side = tileSide, rows = side + 2;
    using Row = std::array<std::int32_t, side>;

    /// @param brickU  may be outside the grid
    void read(const Grid& grid, const VolumeStore& store, const std::vector<BlockIndex>& pages, std::int32_t brickU,
              std::int32_t brickV) {
        changes_.clear();
        const LineIndex low{brickU * tileSide, brickV * tileSide};
        const auto append = [&](std::int32_t v, int firstRow, int behindRow) {
            const LineIndex corner{low.u, v};
            if (!grid.contains(corner))
                return changes_.appendEmpty(side * static_cast<std::size_t>(behindRow - firstRow));
            const Tile tile = store.tile(
                store.page(pages[store.table.pageOf(corner)])[static_cast<std::size_t>(TileTable::entryOf(corner))]);
            const std::uint32_t from = tile.offset(firstRow * tileSide), to = tile.offset(behindRow * tileSide);
            changes_.append({tile.segments() + from, to - from}, grid.lineEnd());
        };
        append(low.v - tileSide, tileSide - 1, tileSide);
        append(low.v, 0, tileSide);
        append(low.v + tileSide, 0, 1);
        leaveOut(grid.lineCountU() - low.u, grid.lineCountV() - low.v);
        findSimple();
    }

    bool simple() const noexcept { return simple_; }
    /// By row (0: before the brick) and u. Without an interval: `from` no less, and `to` no greater, than any position.
    const Row& from(std::size_t row) const noexcept { return from_[row]; }
    const Row& to(std::size_t row) const noexcept { return to_[row]; }
    std::span<const RunPosition> changes(std::size_t row, std::size_t u) const noexcept {
        return present_[row][u] ? changes_[row * side + u] : std::span<const RunPosition>{};
    }

private:
    /// Excludes lines of bricks at the grid's end that are beyond the grid.
    void leaveOut(std::int32_t presentU, std::int32_t presentV) noexcept {
        for (std::size_t row = 0; row < rows; ++row)
            for (std::size_t u = 0; u < side; ++u)
                present_[row][u] =
                    static_cast<std::int32_t>(u) < presentU && static_cast<std::int32_t>(row) - 1 < presentV;
    }
    void findSimple() noexcept {
        simple_ = true;
        for (std::size_t row = 0; row < rows; ++row)
            for (std::size_t u = 0; u < side; ++u) {
                const std::span<const RunPosition> line = changes_[row * side + u];
                const bool any = present_[row][u] && !line.empty();
                const std::int32_t from = any ? firstVoxelFrom(line[0]) : 0, to = any ? firstVoxelFrom(line[1]) : 0;
                simple_ = simple_ && line.size() <= 2;
                from_[row][u] = from < to ? from : Grid::maximumVoxelsPerAxis;
                to_[row][u] = from < to ? to : -1;
            }
    }

    LineChanges<rows * side> changes_;
    std::array<std::array<bool, side>, rows> present_{};
    std::array<Row, rows> from_{}, to_{};
    bool simple_ = true;
};

/// Processes a row of bricks in the direction of u.
class BoundaryList::Finder {
public:
    explicit Finder(const VolumeSnapshot& volume)
        : grid_(volume.grid()), store_(*VolumeAccess::state(volume).store), pages_(VolumeAccess::state(volume).pages) {}

    /// Bricks firstU … endU - 1 of a row; `bricks` begins with the first.
    void find(std::int32_t brickV, std::int32_t firstU, std::int32_t endU, Brick* bricks) {
        read(firstU - 1, brickV);
        read(firstU, brickV);
        for (std::int32_t u = firstU; u < endU; ++u) {
            read(u + 1, brickV);
            const Surrounding &before = at(u - 1), &here = at(u), &behind = at(u + 1);
            Brick& brick = bricks[u - firstU];
            if (before.simple() && here.simple() && behind.simple())
                findSimple(before, here, behind, brick);
            else
                findAny(before, here, behind, brick);
        }
    }

private:
    static constexpr std::size_t side = tileSide;

    Surrounding& at(std::int32_t brickU) { return surroundings_[static_cast<std::size_t>(brickU + 3) % 3]; }
    void read(std::int32_t brickU, std::int32_t brickV) { at(brickU).read(grid_, store_, pages_, brickU, brickV); }

    /// For lines with one interval each: the intersection of nine is from the greatest begin to the least end.
    void findSimple(const Surrounding& before, const Surrounding& here, const Surrounding& behind, Brick& brick) {
        std::array<VoxelInterval, 2 * linesPerTile> intervals;
        std::size_t found = 0;
        for (std::size_t v = 0; v < side; ++v) {
            std::array<std::int32_t, side + 2> from{}, to{};
            const auto alongV = [&](const Surrounding& brickRow, std::size_t u, std::size_t place) {
                from[place] = std::max({brickRow.from(v)[u], brickRow.from(v + 1)[u], brickRow.from(v + 2)[u]});
                to[place] = std::min({brickRow.to(v)[u], brickRow.to(v + 1)[u], brickRow.to(v + 2)[u]});
            };
            alongV(before, side - 1, 0);
            for (std::size_t u = 0; u < side; ++u) alongV(here, u, u + 1);
            alongV(behind, 0, side + 1);
            for (std::size_t u = 0; u < side; ++u) {
                // The outermost voxels of the intersection are still on the boundary.
                const std::int32_t inner = std::max({from[u], from[u + 1], from[u + 2]});
                const std::int32_t innerEnd = std::min({to[u], to[u + 1], to[u + 2]}) - 1;
                const std::int32_t begin = here.from(v + 1)[u], last = here.to(v + 1)[u] - 1;
                const bool any = begin <= last, split = inner + 1 < innerEnd;
                brick.begin[v * side + u] = static_cast<std::uint32_t>(found);
                intervals[found] = {begin, split ? inner : last};
                found += any ? 1U : 0U;
                intervals[found] = {innerEnd, last};
                found += any && split ? 1U : 0U;
            }
        }
        brick.begin[linesPerTile] = static_cast<std::uint32_t>(found);
        brick.intervals.assign(intervals.begin(), intervals.begin() + static_cast<std::ptrdiff_t>(found));
    }

    /// The intersection of nine lines in two steps: of three along v, then of three such results along u.
    void findAny(const Surrounding& before, const Surrounding& here, const Surrounding& behind, Brick& brick) {
        own_.clear();
        alongV_.clear();
        for (std::size_t u = 0; u < side + 2; ++u)
            for (std::size_t row = 0; row < side + 2; ++row) own_.append(changes(before, here, behind, row, u));
        for (std::size_t u = 0; u < side + 2; ++u)
            for (std::size_t v = 0; v < side; ++v) {
                const std::size_t line = u * (side + 2) + v;
                appendCommonOfThree(alongV_, own_[line], own_[line + 1], own_[line + 2]);
            }
        intervals_.clear();
        for (std::size_t v = 0; v < side; ++v)
            for (std::size_t u = 0; u < side; ++u) {
                brick.begin[v * side + u] = static_cast<std::uint32_t>(intervals_.size());
                common_.clear();
                appendCommonOfThree(common_, alongV_[u * side + v], alongV_[(u + 1) * side + v],
                                    alongV_[(u + 2) * side + v]);
                eachBoundaryInterval(own_[(u + 1) * (side + 2) + v + 1], common_[0],
                                     [&](VoxelInterval interval) { intervals_.push_back(interval); });
            }
        brick.begin[linesPerTile] = static_cast<std::uint32_t>(intervals_.size());
        brick.intervals.assign(intervals_.begin(), intervals_.end());
    }
    static std::span<const RunPosition> changes(const Surrounding& before, const Surrounding& here,
                                                const Surrounding& behind, std::size_t row, std::size_t u) {
        if (u == 0) return before.changes(row, side - 1);
        return u <= side ? here.changes(row, u - 1) : behind.changes(row, 0);
    }
    template <std::size_t count>
    void appendCommonOfThree(PlaceLists<count>& result, VoxelPlaces a, VoxelPlaces b, VoxelPlaces c) {
        between_.clear();
        between_.appendCommon(a, b);
        result.appendCommon(between_[0], c);
    }

    const Grid& grid_;
    const VolumeStore& store_;
    const std::vector<BlockIndex>& pages_;
    std::array<Surrounding, 3> surroundings_;
    PlaceLists<(side + 2) * (side + 2)> own_; ///< u counts slower than v, both starting one line before the brick
    PlaceLists<(side + 2) * side> alongV_;
    PlaceLists<1> between_, common_;
    std::vector<VoxelInterval> intervals_;
};

BoundaryList::BoundaryList(const VolumeSnapshot& volume) : shown_(volume) {
    findAll();
}

void BoundaryList::findAll() {
    const TileTable& table = VolumeAccess::state(shown_).store->table;
    bricksU_ = table.tilesU;
    bricksV_ = table.tilesV;
    bricks_.resize(static_cast<std::size_t>(bricksU_) * static_cast<std::size_t>(bricksV_));
    parallelIntervals(std::int32_t{0}, bricksV_, 1, [&](std::int32_t from, std::int32_t to) {
        Finder finder(shown_);
        for (std::int32_t v = from; v < to; ++v) finder.find(v, 0, bricksU_, &bricks_[brickAt(0, v)]);
    });
}

std::size_t BoundaryList::update(const VolumeSnapshot& now) {
    if (!now.sameVolume(shown_)) {
        shown_ = now;
        findAll();
        return bricks_.size();
    }
    std::vector<std::uint8_t> changed(bricks_.size(), 0);
    for (std::int32_t v = 0; v < bricksV_; ++v)
        for (std::int32_t u = 0; u < bricksU_; ++u) {
            if (now.sharesBrick(shown_, {u * tileSide, v * tileSide})) continue;
            for (std::int32_t nearV = std::max(v - 1, 0); nearV <= std::min(v + 1, bricksV_ - 1); ++nearV)
                for (std::int32_t nearU = std::max(u - 1, 0); nearU <= std::min(u + 1, bricksU_ - 1); ++nearU)
                    changed[brickAt(nearU, nearV)] = 1;
        }
    shown_ = now;
    parallelIntervals(std::int32_t{0}, bricksV_, 1, [&](std::int32_t from, std::int32_t to) {
        Finder finder(shown_);
        for (std::int32_t v = from; v < to; ++v)
            for (std::int32_t u = 0; u < bricksU_; ++u) {
                const std::int32_t first = u;
                while (u < bricksU_ && changed[brickAt(u, v)] != 0) ++u;
                if (u > first) finder.find(v, first, u, &bricks_[brickAt(first, v)]);
            }
    });
    return static_cast<std::size_t>(std::accumulate(changed.begin(), changed.end(), std::ptrdiff_t{0}));
}

std::span<const VoxelInterval> BoundaryList::line(LineIndex line) const noexcept {
    const Brick& brick = bricks_[brickAt(line.u / tileSide, line.v / tileSide)];
    const auto place = static_cast<std::size_t>(TileTable::lineInTile(line));
    return std::span(brick.intervals).subspan(brick.begin[place], brick.begin[place + 1] - brick.begin[place]);
}

std::uint64_t BoundaryList::voxelCount() const noexcept {
    std::uint64_t count = 0;
    for (const Brick& brick : bricks_)
        for (const VoxelInterval interval : brick.intervals)
            count += static_cast<std::uint64_t>(interval.last - interval.first + 1);
    return count;
}

std::vector<VoxelIndex> BoundaryList::voxels() const {
    const Grid& grid = shown_.grid();
    const auto eachInRow = [&](std::int32_t v, auto&& visit) {
        for (std::int32_t u = 0; u < grid.lineCountU(); ++u)
            for (const VoxelInterval interval : line({u, v})) visit(LineIndex{u, v}, interval);
    };
    std::vector<std::size_t> begin(static_cast<std::size_t>(grid.lineCountV()) + 1, 0);
    parallelFor(std::int32_t{0}, grid.lineCountV(), [&](std::int32_t v) {
        eachInRow(v, [&](LineIndex, VoxelInterval interval) {
            begin[static_cast<std::size_t>(v) + 1] += static_cast<std::size_t>(interval.last - interval.first + 1);
        });
    });
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<VoxelIndex> all(begin.back());
    parallelFor(std::int32_t{0}, grid.lineCountV(), [&](std::int32_t v) {
        VoxelIndex* next = all.data() + begin[static_cast<std::size_t>(v)];
        eachInRow(v, [&](LineIndex line, VoxelInterval interval) {
            for (std::int32_t along = interval.first; along <= interval.last; ++along)
                *next++ = grid.voxel(line, along);
        });
    });
    return all;
}

std::vector<VoxelInterval> boundaryOfLine(const VolumeSnapshot& volume, LineIndex line) {
    LineChanges<1> changes;
    PlaceLists<1> own, other, common, result;
    const auto read = [&](LineIndex at, PlaceLists<1>& places) {
        changes.clear();
        changes.appendEmpty(volume.grid().contains(at) ? 0 : 1);
        if (changes.size() == 0) changes.append(volume.line(at), volume.grid().lineEnd());
        places.clear();
        places.append(changes[0]);
    };
    read(line, own);
    result = own;
    for (std::int32_t dv = -1; dv <= 1; ++dv)
        for (std::int32_t du = -1; du <= 1; ++du) {
            read({line.u + du, line.v + dv}, other);
            common.clear();
            common.appendCommon(result[0], other[0]);
            std::swap(result, common);
        }
    std::vector<VoxelInterval> found;
    eachBoundaryInterval(own[0], result[0], [&](VoxelInterval interval) { found.push_back(interval); });
    return found;
}

std::vector<VoxelIndex> boundaryVoxels(const VolumeSnapshot& volume) {
    return BoundaryList(volume).voxels();
}

} // namespace burin
