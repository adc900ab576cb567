// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/surface_field.h"

#include <algorithm>

namespace burin {

namespace {

constexpr std::int64_t blockNodes = 16; ///< nodes along the runs that are told solid, air or mixed as one

std::int64_t floorQuotient(std::int64_t value, std::int64_t divisor) {
    return value >= 0 ? value / divisor : -((divisor - 1 - value) / divisor);
}
std::int64_t ceilingQuotient(std::int64_t value, std::int64_t divisor) {
    return -floorQuotient(-value, divisor);
}

} // namespace

void SurfaceField::aim(const VolumeSnapshot& workpiece, SurfaceTile tile, int level) {
    const Grid& grid = workpiece.grid();
    level_ = level;
    const int tileNodes = linesPerSurfaceTile >> level;
    const auto nodes = [&](std::int32_t voxels) { return (voxels + cell() - 1) / cell(); };
    ownedU_ = std::min(tileNodes, nodes(grid.lineCountU()) - tileNodes * tile.u);
    ownedV_ = std::min(tileNodes, nodes(grid.lineCountV()) - tileNodes * tile.v);
    firstU_ = tileNodes * tile.u - margin;
    firstV_ = tileNodes * tile.v - margin;
    columnsU_ = ownedU_ + 2 * margin;
    columnsV_ = ownedV_ + 2 * margin;

    const int nodesAlong = nodes(grid.voxelsPerLine()) + 2; // one beyond each end: the surface closes there
    const auto blocks = static_cast<std::size_t>(ceilingQuotient(nodesAlong, blockNodes));
    solidBlocks_.assign(blocks, 0);
    airBlocks_.assign(blocks, 0);
    seen_.fill(false);
    const std::int32_t lowU = firstU_ * cell(), highU = (firstU_ + columnsU_) * cell();
    const std::int32_t lowV = firstV_ * cell(), highV = (firstV_ + columnsV_) * cell();
    const LineIndex low{std::max(lowU, 0), std::max(lowV, 0)};
    const LineIndex high{std::min(highU, grid.lineCountU()), std::min(highV, grid.lineCountV())};
    if (low.u != lowU || low.v != lowV || high.u != highU || high.v != highV)
        std::fill(airBlocks_.begin(), airBlocks_.end(), std::uint8_t{1});
    for (std::int32_t u = low.u; u < high.u; ++u)
        for (std::int32_t v = low.v; v < high.v; ++v) mark(workpiece.line({u, v}), grid.lineEnd());

    intervals_.clear();
    for (std::size_t block = 0; block < blocks;) {
        const std::size_t begin = block;
        while (block < blocks && solidBlocks_[block] != 0 && airBlocks_[block] != 0) ++block;
        if (block > begin) {
            const int first = static_cast<int>(begin) * static_cast<int>(blockNodes) - 1;
            const int end = std::min(static_cast<int>(block) * static_cast<int>(blockNodes), nodesAlong) - 1;
            intervals_.push_back({first - overhang, end - first + 2 * overhang});
        } else
            ++block;
    }
    const auto materials = std::count(seen_.begin() + 1, seen_.end(), true);
    const auto material = std::find(seen_.begin() + 1, seen_.end(), true) - seen_.begin();
    onlyProperty_ = materials == 1 ? static_cast<PropertyIndex>(material) : airProperty;
}

void SurfaceField::mark(std::span<const Segment> line, RunPosition lineEnd) {
    constexpr std::int64_t far = std::int64_t{1} << 40; // beyond the grid there is air
    std::int64_t from = -far;
    bool solid = false;
    RunPosition begin = 0;
    for (const Segment segment : line) {
        seen_[segment.property()] = true;
        const bool segmentSolid = segment.property() != airProperty;
        if (segmentSolid != solid && begin > 0) markStretch(solid ? solidBlocks_ : airBlocks_, from, begin);
        if (segmentSolid != solid) {
            if (begin == 0) markStretch(airBlocks_, from, 0);
            from = begin;
            solid = segmentSolid;
        }
        begin = segment.end();
    }
    if (solid) {
        markStretch(solidBlocks_, from, lineEnd);
        from = lineEnd;
    }
    markStretch(airBlocks_, from, far);
}

/// A node sees the cells to either side of its centre.
void SurfaceField::markStretch(std::vector<std::uint8_t>& blocks, std::int64_t from, std::int64_t to) const {
    const std::int64_t node = std::int64_t{unitsPerVoxel} << level_;
    const std::int64_t first = floorQuotient(from + node / 2, blockNodes * node);
    const std::int64_t last = ceilingQuotient(to + node + node / 2, blockNodes * node);
    const auto limit = static_cast<std::int64_t>(blocks.size());
    std::fill(blocks.begin() + std::clamp<std::int64_t>(first, 0, limit),
              blocks.begin() + std::clamp<std::int64_t>(last, 0, limit), std::uint8_t{1});
}

void SurfaceField::fill(const VolumeSnapshot& workpiece, Interval interval) {
    const Grid& grid = workpiece.grid();
    filled_ = interval;
    const auto values = static_cast<std::size_t>(columnsU_ * columnsV_) * static_cast<std::size_t>(interval.count);
    raw_.resize(values);
    smoothAlongV_.resize(values);
    smooth_.resize(values);
    for (int u = 0; u < columnsU_; ++u)
        for (int v = 0; v < columnsV_; ++v) {
            sum_.assign(static_cast<std::size_t>(interval.count), 0);
            const LineIndex low{(firstU_ + u) * cell(), (firstV_ + v) * cell()};
            for (std::int32_t lineU = std::max(low.u, 0); lineU < std::min(low.u + cell(), grid.lineCountU()); ++lineU)
                for (std::int32_t lineV = std::max(low.v, 0); lineV < std::min(low.v + cell(), grid.lineCountV());
                     ++lineV)
                    addLine(workpiece.line({lineU, lineV}));
            storeColumn(raw_.data() + offset(u, v));
        }
    smooth();
}

void SurfaceField::addLine(std::span<const Segment> line) {
    RunPosition begin = 0, from = 0;
    bool solid = false;
    for (const Segment segment : line) {
        const bool segmentSolid = segment.property() != airProperty;
        if (segmentSolid && !solid) from = begin;
        if (!segmentSolid && solid) addStretch(from, begin);
        solid = segmentSolid;
        begin = segment.end();
    }
    if (solid) addStretch(from, begin);
}

void SurfaceField::addStretch(std::int64_t from, std::int64_t to) {
    const std::int64_t node = std::int64_t{unitsPerVoxel} << level_, end = filled_.count;
    // Node n sees from (n - 1/2) to (n + 3/2) nodes; here n counts from the interval's first.
    const std::int64_t low = from - filled_.first * node, high = to - filled_.first * node;
    const auto partly = [&](std::int64_t begin, std::int64_t behind) {
        for (std::int64_t n = begin; n < behind; ++n) {
            const std::int64_t sees = n * node - node / 2;
            const std::int64_t solid = std::min(high, sees + 2 * node) - std::max(low, sees);
            sum_[static_cast<std::size_t>(n)] += static_cast<std::uint32_t>(std::max<std::int64_t>(solid, 0));
        }
    };
    const std::int64_t first = std::clamp<std::int64_t>(floorQuotient(low - 3 * node / 2, node), 0, end);
    const std::int64_t behind = std::clamp<std::int64_t>(ceilingQuotient(high + node / 2, node), first, end);
    const std::int64_t fullFirst = std::clamp<std::int64_t>(ceilingQuotient(low + node / 2, node), first, behind);
    const std::int64_t fullBehind =
        std::clamp<std::int64_t>(floorQuotient(high - 3 * node / 2, node) + 1, fullFirst, behind);
    partly(first, fullFirst);
    const auto whole = static_cast<std::uint32_t>(2 * node);
    for (std::int64_t n = fullFirst; n < fullBehind; ++n) sum_[static_cast<std::size_t>(n)] += whole;
    partly(fullBehind, behind);
}

/// Scales to 0 … 512 (level 0) or 0 … 2048: sixteen times that, which smoothing makes of it, fits 16 bits.
void SurfaceField::storeColumn(std::uint16_t* column) const {
    const int shift = level_ == 0 ? 0 : 3 * level_ - 2;
    for (std::size_t n = 0; n < sum_.size(); ++n) column[n] = static_cast<std::uint16_t>(sum_[n] >> shift);
}

void SurfaceField::smooth() {
    const auto count = static_cast<std::size_t>(filled_.count);
    const auto average = [count](const std::uint16_t* before, const std::uint16_t* at, const std::uint16_t* behind,
                                 std::uint16_t* result) {
        for (std::size_t n = 0; n < count; ++n)
            result[n] = static_cast<std::uint16_t>(before[n] + 2 * at[n] + behind[n]);
    };
    for (int u = 0; u < columnsU_; ++u)
        for (int v = 1; v + 1 < columnsV_; ++v)
            average(raw_.data() + offset(u, v - 1), raw_.data() + offset(u, v), raw_.data() + offset(u, v + 1),
                    smoothAlongV_.data() + offset(u, v));
    for (int u = 1; u + 1 < columnsU_; ++u)
        for (int v = 1; v + 1 < columnsV_; ++v)
            average(smoothAlongV_.data() + offset(u - 1, v), smoothAlongV_.data() + offset(u, v),
                    smoothAlongV_.data() + offset(u + 1, v), smooth_.data() + offset(u, v));
}

} // namespace burin
