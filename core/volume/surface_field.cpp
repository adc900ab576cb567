// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/surface_field.h"

#include "core/volume/volume_access.h"

#include <algorithm>

namespace burin {

namespace {

constexpr std::int64_t blockNodes = 16; ///< nodes along the runs that are told solid, air or mixed as one
constexpr int shortInterval = 120;      ///< nodes of 256 units, two of which more fit 16 bits

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
}

std::span<const SurfaceField::Interval> SurfaceField::findIntervals(const VolumeSnapshot& workpiece) {
    const Grid& grid = workpiece.grid();
    // One node beyond each end: the surface closes there.
    const int nodesAlong = (grid.voxelsPerLine() + cell() - 1) / cell() + 2;
    const auto blocks = static_cast<std::size_t>(ceilingQuotient(nodesAlong, blockNodes));
    solidBlocks_.assign(blocks, 0);
    airBlocks_.assign(blocks, 0);
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
            // Beyond the blocks nothing crosses, so all nodes but the last may own what they find.
            const int from = first - overhang, count = end - first + 2 * overhang;
            intervals_.push_back({from, count, from, from + count - 1});
        } else
            ++block;
    }
    return intervals_;
}

SurfaceField::Interval SurfaceField::brickInterval(const Grid& grid, std::int32_t brick) {
    const int begin = brick == 0 ? -1 : brick * linesPerSurfaceTile; // the surface closes before the first voxel
    const int end = std::min((brick + 1) * linesPerSurfaceTile, grid.voxelsPerLine());
    return {begin - overhang, end - begin + 2 * overhang, begin, end};
}

void SurfaceField::mark(std::span<const Segment> line, RunPosition lineEnd) {
    constexpr std::int64_t far = std::int64_t{1} << 40; // beyond the grid there is air
    std::int64_t from = -far;
    bool solid = false;
    RunPosition begin = 0;
    for (const Segment segment : line) {
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
    filled_ = interval;
    seen_.fill(false);
    const auto values = static_cast<std::size_t>(columnsU_ * columnsV_) * static_cast<std::size_t>(interval.count);
    raw_.resize(values);
    smoothAlongV_.resize(values);
    smooth_.resize(values);
    // Places within a brick fit 16 bits, of which twice as many are worked on at once.
    if (level_ == 0 && interval.count <= shortInterval)
        fillColumns<std::int16_t>(workpiece);
    else
        fillColumns<std::int32_t>(workpiece);
    smooth();
}

/// A node's solid is scaled to 0 … 512 (level 0) or 0 … 2048: sixteen times that, which smoothing makes of it, fits 16
/// bits.
template <class Sum>
void SurfaceField::fillColumns(const VolumeSnapshot& workpiece) {
    const VolumeState& state = VolumeAccess::state(workpiece);
    const Grid& grid = workpiece.grid();
    const auto count = static_cast<std::size_t>(filled_.count);
    const int shift = level_ == 0 ? 0 : 3 * level_ - 2;
    std::vector<Sum> sums(count);
    for (int u = 0; u < columnsU_; ++u)
        for (int v = 0; v < columnsV_; ++v) {
            std::fill(sums.begin(), sums.end(), Sum{0});
            const LineIndex low{(firstU_ + u) * cell(), (firstV_ + v) * cell()};
            for (std::int32_t lineU = std::max(low.u, 0); lineU < std::min(low.u + cell(), grid.lineCountU()); ++lineU)
                for (std::int32_t lineV = std::max(low.v, 0); lineV < std::min(low.v + cell(), grid.lineCountV());
                     ++lineV)
                    addLine(state.store->line(state.pages, {lineU, lineV}), sums.data());
            std::uint16_t* const column = raw_.data() + offset(u, v);
            for (std::size_t n = 0; n < count; ++n) column[n] = static_cast<std::uint16_t>(sums[n] >> shift);
        }
}

template <class Sum>
void SurfaceField::addLine(std::span<const Segment> line, Sum* sums) {
    // Materials count as far as a point's own may be looked for.
    constexpr std::int64_t reach = 2;
    const std::int64_t node = std::int64_t{unitsPerVoxel} << level_;
    const std::int64_t low = (filled_.first - reach) * node, high = (filled_.first + filled_.count + reach) * node;
    std::int64_t begin = 0, from = 0;
    bool solid = false;
    for (const Segment segment : line) {
        const std::int64_t end = segment.end();
        if (end > low) {
            const bool segmentSolid = segment.property() != airProperty;
            seen_[segment.property()] = true;
            if (segmentSolid && !solid) from = begin;
            if (!segmentSolid && solid) addStretch(from, begin, sums);
            solid = segmentSolid;
            if (end >= high) {
                begin = end;
                break;
            }
        }
        begin = end;
    }
    if (solid) addStretch(from, begin, sums);
}

/// Node n sees from (n - 1/2) to (n + 3/2) nodes.
template <class Sum>
void SurfaceField::addStretch(std::int64_t from, std::int64_t to, Sum* sums) const {
    const int node = static_cast<int>(unitsPerVoxel) << level_, count = filled_.count;
    const std::int64_t origin = std::int64_t{filled_.first} * node, end = std::int64_t{count + 1} * node;
    const auto low = static_cast<Sum>(std::clamp<std::int64_t>(from - origin, -node, end));
    const auto high = static_cast<Sum>(std::clamp<std::int64_t>(to - origin, -node, end));
    const auto whole = static_cast<Sum>(2 * node);
    for (int n = 0; n < count; ++n) {
        const auto sees = static_cast<Sum>(n * node - node / 2);
        const auto solid = static_cast<Sum>(std::min<Sum>(high, static_cast<Sum>(sees + whole)) - std::max(low, sees));
        sums[n] = static_cast<Sum>(sums[n] + std::max<Sum>(solid, 0));
    }
}

PropertyIndex SurfaceField::onlyProperty() const {
    const auto first = std::find(seen_.begin() + 1, seen_.end(), true);
    const bool one = first != seen_.end() && std::find(first + 1, seen_.end(), true) == seen_.end();
    return one ? static_cast<PropertyIndex>(first - seen_.begin()) : airProperty;
}

bool SurfaceField::holdsProtected(const PropertyList& properties) const {
    for (std::size_t i = 1; i < seen_.size(); ++i)
        if (seen_[i] && properties.isProtected(static_cast<PropertyIndex>(i))) return true;
    return false;
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
