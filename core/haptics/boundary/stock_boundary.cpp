// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/boundary/stock_boundary.h"

#include "core/cutting/line_frame.h"
#include "core/cutting/pose_steps.h"
#include "core/haptics/boundary/mesh_boundary.h"
#include "core/haptics/boundary/stock_search.h"

namespace burin {
namespace {

/// Shank and holder, as far as they are pieces.
std::vector<RevolvedPiece> guardedPieces(const Cutter& cutter) {
    const std::vector<RevolvedPiece> all = pieces(cutter);
    std::vector<RevolvedPiece> guarded;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const ToolSection section = sectionOf(cutter, i);
        if (section == ToolSection::holder || (section == ToolSection::shank && cutter.turns()))
            guarded.push_back(all[i]);
    }
    return guarded;
}

} // namespace

StockBoundary::StockBoundary(const RunVolume& workpiece, const Cutter& cutter, double distance)
    : workpiece_(&workpiece)
    , guarded_(guardedPieces(cutter))
    , distance_(distance)
    , reach_(reachOf(pieces(cutter)))
    , overlap_(overlapOf(pieces(cutter)))
    , bricks_(workpiece.grid()) {}

void StockBoundary::beginTick(const CutCache* owed, bool cuts) noexcept {
    owed_ = owed;
    cuts_ = cuts;
    newest_.forget();
}

PoseSample StockBoundary::at(const ToolPose& pose, double enough) noexcept {
    return newest_.at(pose, enough, [this](const ToolPose& at, double within) { return ask(at, within); });
}

PoseSample StockBoundary::ask(const ToolPose& pose, double enough) noexcept {
    PoseSample sample{enough, glm::dvec3(0.0), glm::dvec3(0.0), false};
    if (!cuts_ || !isFinite(pose.tip) || !isFinite(pose.axis)) return sample;
    const Grid& grid = workpiece_->grid();
    const ToolPose inLines = inLineFrame(grid, pose);
    StockSearch search(*workpiece_, owed_, bricks_, enough + distance_, visited_);
    for (const RevolvedPiece& piece : guarded_) search.tryLine(PlacedPiece(piece, inLines), nearest_);
    for (const RevolvedPiece& piece : guarded_) search.search(PlacedPiece(piece, inLines));
    const NearStock& near = search.nearest();
    if (!near.any) return sample;
    nearest_ = near.line;
    sample.clearance = near.distance - distance_;
    sample.gradient = -inSetupFrame(grid, near.gradient);
    const glm::dvec3 turning = glm::cross(inSetupFrame(grid, near.point) - pose.tip, sample.gradient);
    sample.turning = turning - glm::dot(turning, pose.axis) * pose.axis;
    sample.fine = true;
    return sample;
}

} // namespace burin
