// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/contact.h"
#include "core/cutting/footprint.h"
#include "core/cutting/line_frame.h"
#include "core/tool/swept_span.h"
#include "core/volume/boundary.h"

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

/// Voxels of the guarded pieces, by their centres.
class ToolVoxels {
public:
    ToolVoxels(const Grid& grid, std::span<const RevolvedPiece> guarded, const ToolPose& pose)
        : grid_(grid), guarded_(guarded), pose_(pose) {}

    bool contains(const glm::ivec3& voxel) const {
        const glm::dvec3 centre = grid_.low() + (glm::dvec3(voxel) + 0.5) * grid_.edge() - pose_.tip;
        const double height = glm::dot(centre, pose_.axis);
        const double radius = glm::length(centre - height * pose_.axis);
        return std::ranges::any_of(
            guarded_, [&](const RevolvedPiece& piece) { return signedDistance(piece, radius, height) <= 0.0; });
    }
    bool onSurface(const glm::ivec3& voxel) const {
        if (!contains(voxel)) return false;
        for (int i = -1; i <= 1; ++i)
            for (int j = -1; j <= 1; ++j)
                for (int k = -1; k <= 1; ++k)
                    if (!contains(voxel + glm::ivec3(i, j, k))) return true;
        return false;
    }

private:
    const Grid& grid_;
    std::span<const RevolvedPiece> guarded_;
    ToolPose pose_;
};

} // namespace

std::vector<VoxelIndex> collisionArea(const VolumeSnapshot& workpiece, std::span<const RevolvedPiece> tool,
                                      std::size_t fluteCount, const ToolPose& pose) {
    std::vector<VoxelIndex> area;
    if (!isFinite(pose.tip) || !isFinite(pose.axis) || fluteCount >= tool.size()) return area;
    const Grid& grid = workpiece.grid();
    const std::span<const RevolvedPiece> guarded = tool.subspan(fluteCount);
    const ToolPose linePose = inLineFrame(grid, pose);
    Box reach;
    for (const RevolvedPiece& piece : guarded)
        reach.include(SweptPiece(piece, linePose.tip, linePose.tip, linePose.axis).bounds());
    const glm::dvec3 low = inLineFrame(grid, grid.low());
    const LineRange us = linesWithin({reach.low.x, reach.high.x}, low.x, grid.edge(), grid.lineCountU());
    const LineRange vs = linesWithin({reach.low.y, reach.high.y}, low.y, grid.edge(), grid.lineCountV());
    const LineRange along = linesWithin({reach.low.z, reach.high.z}, low.z, grid.edge(), grid.voxelsPerLine());
    const ToolVoxels voxels(grid, guarded, pose);
    for (LineIndex line{us.first, vs.first}; line.v <= vs.last; ++line.v)
        for (line.u = us.first; line.u <= us.last; ++line.u)
            for (const VoxelStretch& stretch : boundaryOfLine(workpiece, line))
                for (std::int32_t k = std::max(stretch.first, along.first); k <= std::min(stretch.last, along.last);
                     ++k) {
                    const VoxelIndex voxel = grid.voxel(line, k);
                    if (voxels.onSurface({voxel.i, voxel.j, voxel.k})) area.push_back(voxel);
                }
    return area;
}

} // namespace burin
