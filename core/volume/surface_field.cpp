// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/surface_field.h"

#include "core/volume/surface_lanes.h"
#include "core/volume/volume_access.h"

#include <algorithm>

namespace burin {

namespace {

constexpr std::int64_t blockNodes = 16; ///< nodes along the runs that are told solid, air or mixed as one
constexpr int shortInterval = 120;      ///< nodes of 256 units, two of which more fit 16 bits

/// Columns are worked on so many nodes at a time; the ones too many are right, too.
constexpr int wholeLanes(int nodes) {
    constexpr int lanes = nodeLanes;
    return (nodes + lanes - 1) / lanes * lanes;
}

/// Looks lines up that mostly lie in one brick.
class LineReader {
public:
    explicit LineReader(const VolumeSnapshot& workpiece) : state_(VolumeAccess::state(workpiece)) {}
    std::span<const Segment> at(LineIndex line) {
        const LineIndex brick{line.u / tileSide, line.v / tileSide};
        if (brick != brick_) {
            brick_ = brick;
            tile_ = state_.store->tile(VolumeAccess::tileAt(state_, brick.u, brick.v));
        }
        return tile_.line(TileTable::lineInTile(line));
    }

private:
    const VolumeState& state_;
    LineIndex brick_{-1, -1};
    Tile tile_{nullptr};
};

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
            const int from = first - overhang, behind = end + overhang;
            intervals_.push_back({from, wholeLanes(behind - from), from, behind - 1});
        } else
            ++block;
    }
    return intervals_;
}

SurfaceField::Interval SurfaceField::brickInterval(const Grid& grid, std::int32_t brick) {
    const int begin = brick == 0 ? -1 : brick * linesPerSurfaceTile; // the surface closes before the first voxel
    const int end = std::min((brick + 1) * linesPerSurfaceTile, grid.voxelsPerLine());
    return {begin - overhang, wholeLanes(end - begin + 2 * overhang), begin, end};
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
    // Places within a brick fit 16 bits, of which twice as many are worked on at once.
    if (level_ == 0 && interval.count <= shortInterval)
        fillShort(workpiece);
    else
        fillLong(workpiece);
    smooth();
}

void SurfaceField::makeRoom() {
    const auto values = static_cast<std::size_t>(columnsU_ * columnsV_) * static_cast<std::size_t>(filled_.count);
    raw_.resize(values);
    smoothAlongV_.resize(values);
    smooth_.resize(values);
}

/// A column is one line. All lines are read first: nodes before the first place and behind the last one at which any of
/// them changes are alike, and are left out.
void SurfaceField::fillShort(const VolumeSnapshot& workpiece) {
    const Grid& grid = workpiece.grid();
    constexpr int node = static_cast<int>(unitsPerVoxel);
    const int origin = filled_.first * node, end = (filled_.count + 1) * node;
    const auto within = [&](RunPosition position) {
        return static_cast<std::int16_t>(std::clamp(static_cast<int>(position) - origin, -node, end));
    };
    LineReader lines(workpiece);
    stretches_.clear();
    firstStretch_.clear();
    bool solidAtBegin = false, airAtBegin = false, solidAtEnd = false, airAtEnd = false;
    int firstChange = end, lastChange = -node;
    for (std::int32_t u = firstU_; u < firstU_ + columnsU_; ++u)
        for (std::int32_t v = firstV_; v < firstV_ + columnsV_; ++v) {
            const std::size_t first = stretches_.size();
            firstStretch_.push_back(first);
            if (grid.contains(LineIndex{u, v}))
                eachStretch(lines.at({u, v}), [&](RunPosition from, RunPosition to) {
                    const Stretch16 stretch{within(from), within(to)};
                    if (stretch.low == stretch.high) return;
                    stretches_.push_back(stretch);
                    if (stretch.low > -node) firstChange = std::min<int>(firstChange, stretch.low);
                    if (stretch.low > -node) lastChange = std::max<int>(lastChange, stretch.low);
                    if (stretch.high < end) firstChange = std::min<int>(firstChange, stretch.high);
                    if (stretch.high < end) lastChange = std::max<int>(lastChange, stretch.high);
                });
            const bool any = stretches_.size() > first;
            const bool begins = any && stretches_[first].low == -node, ends = any && stretches_.back().high == end;
            (begins ? solidAtBegin : airAtBegin) = true;
            (ends ? solidAtEnd : airAtEnd) = true;
        }
    firstStretch_.push_back(stretches_.size());
    if (solidAtBegin && airAtBegin) firstChange = -node;
    if (solidAtEnd && airAtEnd) lastChange = end;
    narrow(firstChange, lastChange);

    makeRoom();
    const auto count = static_cast<std::size_t>(filled_.count);
    const int shift = filled_.first * node - origin;
    for (std::size_t column = 0; column + 1 < firstStretch_.size(); ++column) {
        auto* const sums = reinterpret_cast<std::int16_t*>(raw_.data() + column * count);
        std::fill_n(sums, count, std::int16_t{0});
        for (std::size_t i = firstStretch_[column]; i < firstStretch_[column + 1]; ++i)
            addSeen(static_cast<std::int16_t>(stretches_[i].low - shift),
                    static_cast<std::int16_t>(stretches_[i].high - shift), count, sums);
    }
}

/// Leaves the nodes where something changes, and `overhang` more on either side.
/// @param firstChange, lastChange in run units from the interval's first node
void SurfaceField::narrow(int firstChange, int lastChange) {
    constexpr int node = static_cast<int>(unitsPerVoxel), reach = overhang + 2; // a node sees two of the changes' nodes
    if (firstChange > lastChange) {
        filled_.count = 0;
        return;
    }
    const int first = std::max(0, firstChange / node - reach);
    const int end = std::min(filled_.count, wholeLanes(lastChange / node + reach + 1 - first) + first);
    filled_.first += first;
    filled_.count = wholeLanes(end - first);
    filled_.owned = std::max(filled_.owned, filled_.first);
    filled_.ownedEnd = std::max(filled_.owned, std::min(filled_.ownedEnd, filled_.first + filled_.count - 1));
}

/// A node's solid is scaled to 0 … 512 (level 0) or 0 … 2048: sixteen times that, which smoothing makes of it, fits 16
/// bits.
void SurfaceField::fillLong(const VolumeSnapshot& workpiece) {
    const Grid& grid = workpiece.grid();
    const auto count = static_cast<std::size_t>(filled_.count);
    const int shift = level_ == 0 ? 0 : 3 * level_ - 2;
    makeRoom();
    std::vector<int> sums(count);
    LineReader lines(workpiece);
    for (int u = 0; u < columnsU_; ++u) {
        const std::int32_t lowU = (firstU_ + u) * cell(), highU = std::min(lowU + cell(), grid.lineCountU());
        for (int v = 0; v < columnsV_; ++v) {
            std::ranges::fill(sums, 0);
            const std::int32_t lowV = (firstV_ + v) * cell(), highV = std::min(lowV + cell(), grid.lineCountV());
            for (std::int32_t lineU = std::max(lowU, 0); lineU < highU; ++lineU)
                for (std::int32_t lineV = std::max(lowV, 0); lineV < highV; ++lineV)
                    eachStretch(lines.at({lineU, lineV}),
                                [&](RunPosition from, RunPosition to) { addStretch(from, to, sums); });
            std::uint16_t* const column = raw_.data() + offset(u, v);
            for (std::size_t n = 0; n < count; ++n) column[n] = static_cast<std::uint16_t>(sums[n] >> shift);
        }
    }
}

/// Calls visit(from, to) for the stretches of a line that hold material, as far as they lie near the nodes.
template <class Visit>
void SurfaceField::eachStretch(std::span<const Segment> line, Visit visit) {
    // Materials count as far as a point's own may be looked for.
    constexpr std::int64_t reach = 2;
    const std::int64_t node = std::int64_t{unitsPerVoxel} << level_;
    const auto last = static_cast<std::int64_t>(line.back().end());
    const auto low = static_cast<RunPosition>(std::clamp((filled_.first - reach) * node, std::int64_t{0}, last));
    const auto high =
        static_cast<RunPosition>(std::clamp((filled_.first + filled_.count + reach) * node, std::int64_t{0}, last));
    const Segment* segment = line.data();
    RunPosition begin = 0;
    for (; segment->end() <= low && segment->end() < last; ++segment) begin = segment->end();
    bool solid = false;
    RunPosition from = 0;
    for (;; ++segment) {
        const bool segmentSolid = segment->property() != airProperty;
        seen_[segment->property()] = true;
        if (segmentSolid && !solid) from = begin;
        if (!segmentSolid && solid) visit(from, begin);
        solid = segmentSolid;
        begin = segment->end();
        if (begin >= high) break;
    }
    if (solid) visit(from, begin);
}

/// Node n sees from (n - 1/2) to (n + 3/2) nodes.
void SurfaceField::addStretch(RunPosition from, RunPosition to, std::span<int> sums) const {
    const int node = static_cast<int>(unitsPerVoxel) << level_, origin = filled_.first * node;
    const int low = static_cast<int>(from) - origin, high = static_cast<int>(to) - origin;
    const int count = filled_.count;
    for (int n = 0; n < count; ++n) {
        const int sees = n * node - node / 2;
        sums[static_cast<std::size_t>(n)] += std::max(std::min(high, sees + 2 * node) - std::max(low, sees), 0);
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
    for (int u = 0; u < columnsU_; ++u)
        for (int v = 1; v + 1 < columnsV_; ++v)
            averageColumns(raw_.data() + offset(u, v - 1), raw_.data() + offset(u, v), raw_.data() + offset(u, v + 1),
                           count, smoothAlongV_.data() + offset(u, v));
    for (int u = 1; u + 1 < columnsU_; ++u)
        for (int v = 1; v + 1 < columnsV_; ++v)
            averageColumns(smoothAlongV_.data() + offset(u - 1, v), smoothAlongV_.data() + offset(u, v),
                           smoothAlongV_.data() + offset(u + 1, v), count, smooth_.data() + offset(u, v));
}

} // namespace burin
