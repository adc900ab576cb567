// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/solid_columns.h"

#include "core/base/progress.h"
#include "core/cutting/line_frame.h"
#include "core/cutting/voxel_tool.h"
#include "core/tool/tool.h"
#include "core/volume/runs/run_volume.h"
#include "core/volume/voxelisation/voxelisation.h"

#include <cmath>
#include <limits>
#include <new>
#include <utility>

namespace burin {

namespace {

constexpr double mostLines = 2'000'000; // of all layers together: 4 bytes each, and 8 for each run

/// A result of the volume that only a lack of memory can deny: the sizes were checked before.
template <class Value>
Value allocated(Result<Value> result) {
    if (!result) throw std::bad_alloc();
    return std::move(*result);
}

/// Voxels that an interval of voxels covers, from `first` on.
std::int32_t voxelsOver(double low, double high, std::int32_t& first) noexcept {
    first = static_cast<std::int32_t>(std::floor(low)) - 1;
    return static_cast<std::int32_t>(std::ceil(high)) + 2 - first;
}

} // namespace

SolidColumns::SolidColumns(const ToolSolid& solid, const Grid& grid) : hasShank_(!solid.shank.empty()) {
    const TriangleMesh flutes = turnedAboutAxis(solid.flutes, solid.angle);
    const TriangleMesh shank = turnedAboutAxis(solid.shank, solid.angle);
    Box box = boundingBox(flutes);
    if (hasShank_) box.include(boundingBox(shank));
    low_ = inLineFrame(grid, box.low) / grid.edge();
    high_ = inLineFrame(grid, box.high) / grid.edge();
    const double lines = (high_.x - low_.x + 4.0) * (high_.y - low_.y + 4.0);
    while (points_ > 1 && lines * points_ * points_ > mostLines) points_ /= 2;
    for (std::int32_t v = 0; v < points_; ++v)
        for (std::int32_t u = 0; u < points_; ++u) addLayer(flutes, shank, grid, u, v);
}

std::shared_ptr<const SolidColumns> columnsOf(const Cutter& cutter, const Grid& grid) {
    return cutter.solid != nullptr ? std::make_shared<const SolidColumns>(*cutter.solid, grid) : nullptr;
}

/// @param lines the grid of the workpiece; its edge and its axis of runs count
void SolidColumns::addLayer(const TriangleMesh& flutes, const TriangleMesh& shank, const Grid& lines,
                            std::int32_t pointU, std::int32_t pointV) {
    // The tip lies pointU / points_ voxels above the low side of its line.
    const glm::dvec3 shift(static_cast<double>(pointU) / points_, static_cast<double>(pointV) / points_, 0.0);
    Layer layer;
    std::int32_t along = 0;
    layer.countU = voxelsOver(low_.x + shift.x, high_.x + shift.x, layer.lowU);
    layer.countV = voxelsOver(low_.y + shift.y, high_.y + shift.y, layer.lowV);
    const std::int32_t length = voxelsOver(low_.z, high_.z, along);
    const glm::dvec3 low = (glm::dvec3(layer.lowU, layer.lowV, along) - shift) * lines.edge();
    const glm::dvec3 count = inSetupFrame(lines, {layer.countU, layer.countV, length});
    const Grid own = allocated(Grid::make(inSetupFrame(lines, low), lines.edge(), glm::ivec3(count), lines.axis()));
    RunVolume volume = allocated(RunVolume::make(own, toolProperties()));
    std::vector<BodyMesh> bodies{{&flutes, VoxelTool::flutes, 1}};
    if (hasShank_) bodies.push_back({&shank, VoxelTool::shank, 0});
    Progress progress;
    (void)allocated(voxelise(bodies, volume, progress));
    Layer guarded = layer;
    const auto origin = static_cast<std::int32_t>(along * static_cast<std::int64_t>(unitsPerVoxel));
    for (LineIndex line{0, 0}; line.v < layer.countV; ++line.v)
        for (line.u = 0; line.u < layer.countU; ++line.u) {
            layer.begin.push_back(static_cast<std::uint32_t>(layer.pieces.size()));
            if (hasShank_) guarded.begin.push_back(static_cast<std::uint32_t>(guarded.pieces.size()));
            std::int32_t from = origin;
            for (const Segment segment : volume.line(line)) {
                const std::int32_t to = origin + static_cast<std::int32_t>(segment.end());
                if (segment.property() == VoxelTool::flutes) layer.pieces.push_back({from, to});
                if (segment.property() == VoxelTool::shank) guarded.pieces.push_back({from, to});
                from = to;
            }
        }
    layer.begin.push_back(static_cast<std::uint32_t>(layer.pieces.size()));
    flutes_.push_back(std::move(layer));
    if (!hasShank_) return;
    guarded.begin.push_back(static_cast<std::uint32_t>(guarded.pieces.size()));
    shank_.push_back(std::move(guarded));
}

namespace {

/// A tip in voxels from the low corner of a grid, line frame.
glm::dvec3 voxelsFrom(const Grid& grid, const glm::dvec3& tip) noexcept {
    return inLineFrame(grid, tip - grid.low()) / grid.edge();
}

/// The part of a move, as shares of it, in which a box around the tool reaches into the grid; low > high if none.
std::pair<double, double> shareNear(const glm::dvec3& from, const glm::dvec3& to, const glm::dvec3& low,
                                    const glm::dvec3& high) noexcept {
    double first = 0.0, last = 1.0;
    for (int axis = 0; axis < 3; ++axis) {
        const double way = to[axis] - from[axis];
        if (way == 0.0) {
            if (from[axis] < low[axis] || from[axis] > high[axis]) return {1.0, 0.0};
            continue;
        }
        const double a = (low[axis] - from[axis]) / way, b = (high[axis] - from[axis]) / way;
        first = std::max(first, std::min(a, b));
        last = std::min(last, std::max(a, b));
    }
    return {first, last};
}

std::int64_t floorOf(double value) noexcept {
    return static_cast<std::int64_t>(std::floor(value));
}

/// Splits a point of the lattice into a line and the rest.
std::pair<std::int32_t, std::int32_t> lineAndRest(std::int64_t point, std::int32_t points) noexcept {
    const std::int64_t line = point >= 0 ? point / points : -((points - 1 - point) / points);
    return {static_cast<std::int32_t>(line), static_cast<std::int32_t>(point - line * points)};
}

SolidStay stayAt(std::int64_t pointU, std::int64_t pointV, std::int32_t points, double one, double other) noexcept {
    const auto [u, restU] = lineAndRest(pointU, points);
    const auto [v, restV] = lineAndRest(pointV, points);
    const std::int64_t a = floorOf(one + 0.5), b = floorOf(other + 0.5);
    return {u, v, restU + points * restV, std::min(a, b), std::max(a, b)};
}

} // namespace

SolidTrack::SolidTrack(const SolidColumns& columns, const Grid& grid, const glm::dvec3& from,
                       const glm::dvec3& to) noexcept
    : points_(columns.points_) {
    const glm::dvec3 a = voxelsFrom(grid, from), b = voxelsFrom(grid, to);
    constexpr double farthest = 1e9; // voxels: no grid is that far away; also for what is not finite
    if (!(glm::length(a) < farthest && glm::length(b) < farthest)) return;
    constexpr double slack = 2.0; // voxels, for the lattice
    const glm::dvec3 end(grid.lineCountU(), grid.lineCountV(), grid.voxelsPerLine());
    const auto [first, last] = shareNear(a, b, -columns.high_ - slack, end - columns.low_ + slack);
    if (!(first <= last)) return;
    // Nearest point of the lattice: the floor after adding a half.
    const glm::dvec3 scale(points_, points_, static_cast<double>(unitsPerVoxel)), half(0.5, 0.5, 0.0);
    from_ = a * scale + half;
    to_ = b * scale + half;
    more_ = true;
    share_ = first;
    last_ = last;
    const glm::dvec3 start = placeAt(first), stop = placeAt(last);
    u_ = floorOf(start.x);
    v_ = floorOf(start.y);
    stepsU_ = std::abs(floorOf(stop.x) - u_);
    stepsV_ = std::abs(floorOf(stop.y) - v_);
}

glm::dvec3 SolidTrack::placeAt(double share) const noexcept {
    if (share <= 0.0) return from_;
    return share >= 1.0 ? to_ : from_ + share * (to_ - from_);
}

std::optional<SolidStay> SolidTrack::next() noexcept {
    if (!more_) return std::nullopt;
    const glm::dvec3 way = to_ - from_;
    constexpr double never = std::numeric_limits<double>::infinity();
    const auto crossing = [&](int axis, std::int64_t point, std::int64_t steps) {
        if (steps == 0) return never;
        return (static_cast<double>(way[axis] > 0.0 ? point + 1 : point) - from_[axis]) / way[axis];
    };
    const double alongU = crossing(0, u_, stepsU_), alongV = crossing(1, v_, stepsV_);
    const bool ends = stepsU_ == 0 && stepsV_ == 0;
    const double until = ends ? last_ : std::clamp(std::min(alongU, alongV), share_, last_);
    const SolidStay stay = stayAt(u_, v_, points_, placeAt(share_).z, placeAt(until).z);
    share_ = until;
    if (ends) {
        more_ = false;
    } else if (alongU <= alongV) {
        u_ += way.x > 0.0 ? 1 : -1;
        --stepsU_;
    } else {
        v_ += way.y > 0.0 ? 1 : -1;
        --stepsV_;
    }
    return stay;
}

std::optional<SolidStay> SolidTrack::at(const SolidColumns& columns, const Grid& grid, const glm::dvec3& tip) noexcept {
    return SolidTrack(columns, grid, tip, tip).next();
}

} // namespace burin
