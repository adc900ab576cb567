// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/voxel_tool.h"

#include "core/base/numbers.h"
#include "core/cutting/counted_removal.h"
#include "core/cutting/footprint.h"
#include "core/cutting/line_frame.h"
#include "core/volume/runs/voxel_runs.h"

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

bool isFinitePose(const Pose& pose) noexcept {
    const glm::dquat& q = pose.rotation;
    return isFinite(pose.position) && std::isfinite(q.w) && std::isfinite(q.x) && std::isfinite(q.y) &&
           std::isfinite(q.z);
}

double angleBetween(const glm::dquat& a, const glm::dquat& b) noexcept {
    const glm::dquat turn = glm::conjugate(a) * b;
    return 2.0 * std::atan2(std::sqrt(turn.x * turn.x + turn.y * turn.y + turn.z * turn.z), std::abs(turn.w));
}

PropertyIndex propertyIn(std::span<const RevolvedPiece> pieces, std::size_t fluteCount, const glm::dvec3& q) noexcept {
    const double radius = std::hypot(q.x, q.y);
    for (std::size_t i = 0; i < pieces.size(); ++i)
        if (signedDistance(pieces[i], radius, q.z) <= 0.0) return i < fluteCount ? VoxelTool::flutes : VoxelTool::shank;
    return airProperty;
}

} // namespace

PropertyList toolProperties() {
    PropertyList list;
    for (const char* id : {"flutes", "shank"}) {
        Property property;
        property.id = property.name = id;
        (void)list.add(property); // an empty list has room for two
    }
    return list;
}

VoxelTool::VoxelTool(RunVolume shape) noexcept : shape_(std::move(shape)) {
    const Grid& grid = shape_.grid();
    for (LineIndex line; line.v < grid.lineCountV(); ++line.v)
        for (line.u = 0; line.u < grid.lineCountU(); ++line.u)
            forEachVoxelRun(shape_.line(line), [&](const Run& run) {
                if (run.property == airProperty) return;
                for (const std::int32_t along : {run.first, run.last}) {
                    const VoxelIndex voxel = grid.voxel(line, along);
                    const glm::dvec3 low = grid.low() + glm::dvec3(voxel.i, voxel.j, voxel.k) * grid.edge();
                    filled_.include(low);
                    filled_.include(low + glm::dvec3(grid.edge()));
                    reach_ = std::max(reach_, glm::length(low + 0.5 * grid.edge()));
                }
            });
}

Result<VoxelTool> VoxelTool::make(RunVolume shape) {
    const RunAmounts amounts = shape.amounts();
    for (std::size_t property = shank + 1; property < amounts.units.size(); ++property)
        if (amounts.units[property] > 0)
            return Error{ErrorCode::argumentInvalid, "shape", std::to_string(property),
                         "flutes (1) and shank (2) only"};
    VoxelTool tool(std::move(shape));
    if (tool.filled_.empty()) return Error{ErrorCode::argumentInvalid, "shape", "0", "at least one voxel"};
    return tool;
}

Result<VoxelTool> VoxelTool::ofPieces(std::span<const RevolvedPiece> pieces, std::size_t fluteCount, double edge) {
    if (pieces.empty() || !(edge > 0.0))
        return Error{ErrorCode::argumentInvalid, "edge", formatShortest(edge), "> 0, and a tool of at least one piece"};
    double widest = 0.0, low = pieces.front().bottom, high = pieces.front().top;
    for (const RevolvedPiece& piece : pieces) {
        widest = std::max(widest, piece.widestRadius());
        low = std::min(low, piece.bottom);
        high = std::max(high, piece.top);
    }
    const double across = 2.0 * std::ceil(widest / edge), along = std::ceil((high - low) / edge);
    if (across > Grid::maximumVoxelsPerAxis || along > Grid::maximumVoxelsPerAxis)
        return Error{ErrorCode::volumeTooLarge, formatShortest(std::max(across, along)), {}, {}};
    const auto side = static_cast<std::int32_t>(across);
    Result<Grid> grid = Grid::make({-0.5 * across * edge, -0.5 * across * edge, low}, edge,
                                   {side, side, static_cast<std::int32_t>(along)});
    if (!grid) return grid.error();
    Result<RunVolume> shape = RunVolume::make(*grid, toolProperties());
    if (!shape) return shape.error();
    std::vector<Segment> segments;
    for (LineIndex line; line.v < side; ++line.v)
        for (line.u = 0; line.u < side; ++line.u) {
            const glm::dvec2 centre = grid->lineCentre(line);
            segments.clear();
            for (std::int32_t k = 0; k < grid->voxelsPerLine(); ++k) {
                const double z = grid->toMillimetres(centreOf(k));
                segments.emplace_back(static_cast<RunPosition>(k + 1) * unitsPerVoxel,
                                      propertyIn(pieces, fluteCount, glm::dvec3(centre, z)));
            }
            if (!shape->setLine(line, segments)) return Error{ErrorCode::outOfMemory, "tool", {}, {}};
        }
    return make(std::move(*shape));
}

PropertyIndex VoxelTool::at(const glm::dvec3& place) const noexcept {
    const Grid& grid = shape_.grid();
    const glm::dvec3 index = glm::floor((place - grid.low()) / grid.edge());
    const glm::dvec3 count(grid.count());
    for (int i = 0; i < 3; ++i)
        if (!(index[i] >= 0.0 && index[i] < count[i])) return airProperty;
    const VoxelIndex voxel{static_cast<std::int32_t>(index.x), static_cast<std::int32_t>(index.y),
                           static_cast<std::int32_t>(index.z)};
    return propertyAt(shape_.line(grid.lineOf(voxel)), centreOf(grid.alongOf(voxel)));
}

std::int32_t VoxelTool::posesFor(const Pose& from, const Pose& to) const noexcept {
    const double way = glm::length(to.position - from.position) + angleBetween(from.rotation, to.rotation) * reach_;
    if (!std::isfinite(way)) return 0;
    // Each step is less than a voxel, so there is one more step than there are whole voxels; plus the first pose.
    const double steps = std::floor(way / shape_.grid().edge()) + 1.0;
    return way > 0.0 ? static_cast<std::int32_t>(std::min(steps, 1e9)) + 1 : 1;
}

Pose VoxelTool::poseOf(const Pose& from, const Pose& to, std::int32_t k, std::int32_t poses) noexcept {
    const double part = poses > 1 ? static_cast<double>(k) / (poses - 1) : 0.0;
    return {from.position + part * (to.position - from.position), glm::slerp(from.rotation, to.rotation, part)};
}

Box VoxelTool::boundsAt(const Pose& pose) const noexcept {
    Box result;
    if (!isFinitePose(pose)) return result;
    for (unsigned i = 0; i < 8; ++i) result.include(pose.position + pose.rotation * filled_.corner(i));
    return result;
}

VoxelCut VoxelTool::cut(RunVolume& workpiece, const Pose& from, const Pose& to) const noexcept {
    VoxelCut cut;
    cut.unitVolume = workpiece.grid().unitVolume();
    if (!isFinitePose(from) || !isFinitePose(to)) return cut;
    const std::int32_t poses = posesFor(from, to);
    RemovedUnits removed;
    for (std::int32_t k = 0; k < poses && cutAt(workpiece, poseOf(from, to, k, poses), cut, removed); ++k) ++cut.poses;
    cut.outOfMemory = removed.outOfMemory;
    cut.volume = static_cast<double>(removed.total) * cut.unitVolume;
    if (removed.total > 0) cut.centroid = centroidOf(removed, workpiece.grid());
    return cut;
}

/// Cuts at one pose; returns false if the workpiece's memory is used up.
bool VoxelTool::cutAt(RunVolume& workpiece, const Pose& pose, VoxelCut& cut, RemovedUnits& removed) const noexcept {
    const Grid& grid = workpiece.grid();
    const Box reach = inLineFrame(grid, boundsAt(pose));
    const glm::dvec3 low = inLineFrame(grid, grid.low());
    const LineInterval us = linesWithin({reach.low.x, reach.high.x}, low.x, grid.edge(), grid.lineCountU());
    const LineInterval vs = linesWithin({reach.low.y, reach.high.y}, low.y, grid.edge(), grid.lineCountV());
    const LineInterval along = linesWithin({reach.low.z, reach.high.z}, low.z, grid.edge(), grid.voxelsPerLine());
    const glm::dquat back = glm::conjugate(pose.rotation);
    const glm::dvec3 step = back * inSetupFrame(grid, {0.0, 0.0, grid.edge()});
    for (LineIndex line{us.first, vs.first}; line.v <= vs.last; ++line.v)
        for (line.u = us.first; line.u <= us.last; ++line.u) {
            const double first = grid.toMillimetres(centreOf(along.first));
            const glm::dvec3 start = back * (inSetupFrame(grid, {grid.lineCentre(line), first}) - pose.position);
            const auto toolAt = [&](std::int32_t k) { return at(start + static_cast<double>(k - along.first) * step); };
            for (std::int32_t k = along.first; k <= along.last;) {
                const PropertyIndex property = toolAt(k);
                std::int32_t end = k + 1;
                while (end <= along.last && toolAt(end) == property) ++end;
                const RunPosition from = static_cast<RunPosition>(k) * unitsPerVoxel;
                const RunPosition to = static_cast<RunPosition>(end) * unitsPerVoxel;
                k = end;
                if (property == shank)
                    forEachPiece(workpiece.line(line), from, to,
                                 [&](PropertyIndex met, RunPosition begin, RunPosition stop) {
                                     cut.touched.units[met] += stop - begin;
                                 });
                if (property != flutes) continue;
                if (!removeCounted(workpiece, line, from, to, cut.removed, removed)) return false;
            }
        }
    return true;
}

} // namespace burin
