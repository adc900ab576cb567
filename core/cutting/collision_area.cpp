// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/contact.h"
#include "core/cutting/footprint.h"
#include "core/cutting/line_frame.h"
#include "core/cutting/voxel_tool.h"
#include "core/tool/swept_span.h"
#include "core/volume/operations/boundary.h"

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

/// Tests voxels for the guarded pieces, by their centres.
class GuardedPieces {
public:
    GuardedPieces(std::span<const RevolvedPiece> guarded, const ToolPose& pose) : guarded_(guarded), pose_(pose) {}

    bool holds(const glm::dvec3& centre) const {
        const glm::dvec3 place = centre - pose_.tip;
        const double height = glm::dot(place, pose_.axis);
        const double radius = glm::length(place - height * pose_.axis);
        return std::ranges::any_of(
            guarded_, [&](const RevolvedPiece& piece) { return signedDistance(piece, radius, height) <= 0.0; });
    }

private:
    std::span<const RevolvedPiece> guarded_;
    ToolPose pose_;
};

/// Tests voxels for the shank of a tool of any shape, by their centres.
class VoxelShank {
public:
    VoxelShank(const VoxelTool& tool, const Pose& pose)
        : tool_(tool), tip_(pose.position), back_(glm::conjugate(pose.rotation)) {}

    bool holds(const glm::dvec3& centre) const { return tool_.at(back_ * (centre - tip_)) == VoxelTool::shank; }

private:
    const VoxelTool& tool_;
    glm::dvec3 tip_;
    glm::dquat back_;
};

/// `Guarded` decides whether the voxel around a point (mm, setup frame) belongs to a part that must not touch.
template <class Guarded>
bool onSurface(const Guarded& guarded, const Grid& grid, const VoxelIndex& voxel) {
    const auto holds = [&](int i, int j, int k) {
        return guarded.holds(grid.low() + (glm::dvec3(voxel.i + i, voxel.j + j, voxel.k + k) + 0.5) * grid.edge());
    };
    if (!holds(0, 0, 0)) return false;
    for (int i = -1; i <= 1; ++i)
        for (int j = -1; j <= 1; ++j)
            for (int k = -1; k <= 1; ++k)
                if (!holds(i, j, k)) return true;
    return false;
}

/// @param reach box around the guarded parts, in the frame of the grid's lines
template <class Guarded>
std::vector<VoxelIndex> commonSurface(const VolumeSnapshot& workpiece, const Guarded& guarded, const Box& reach) {
    std::vector<VoxelIndex> area;
    const Grid& grid = workpiece.grid();
    const glm::dvec3 low = inLineFrame(grid, grid.low());
    const LineInterval us = linesWithin({reach.low.x, reach.high.x}, low.x, grid.edge(), grid.lineCountU());
    const LineInterval vs = linesWithin({reach.low.y, reach.high.y}, low.y, grid.edge(), grid.lineCountV());
    const LineInterval along = linesWithin({reach.low.z, reach.high.z}, low.z, grid.edge(), grid.voxelsPerLine());
    for (LineIndex line{us.first, vs.first}; line.v <= vs.last; ++line.v)
        for (line.u = us.first; line.u <= us.last; ++line.u)
            for (const VoxelInterval& interval : boundaryOfLine(workpiece, line))
                for (std::int32_t k = std::max(interval.first, along.first); k <= std::min(interval.last, along.last);
                     ++k) {
                    const VoxelIndex voxel = grid.voxel(line, k);
                    if (onSurface(guarded, grid, voxel)) area.push_back(voxel);
                }
    return area;
}

} // namespace

std::vector<VoxelIndex> collisionArea(const VolumeSnapshot& workpiece, std::span<const RevolvedPiece> tool,
                                      std::size_t fluteCount, const ToolPose& pose) {
    if (!isFinite(pose.tip) || !isFinite(pose.axis) || fluteCount >= tool.size()) return {};
    const std::span<const RevolvedPiece> guarded = tool.subspan(fluteCount);
    const ToolPose linePose = inLineFrame(workpiece.grid(), pose);
    Box reach;
    for (const RevolvedPiece& piece : guarded)
        reach.include(SweptPiece(piece, linePose.tip, linePose.tip, linePose.axis).bounds());
    return commonSurface(workpiece, GuardedPieces(guarded, pose), reach);
}

std::vector<VoxelIndex> collisionArea(const VolumeSnapshot& workpiece, const VoxelTool& tool, const Pose& pose) {
    const Box reach = tool.boundsAt(pose);
    if (reach.empty()) return {};
    return commonSurface(workpiece, VoxelShank(tool, pose), inLineFrame(workpiece.grid(), reach));
}

} // namespace burin
