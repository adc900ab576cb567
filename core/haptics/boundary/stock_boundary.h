// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cutting/cut_cache.h"
#include "core/cutting/occupied_bricks.h"
#include "core/haptics/boundary/newest_sample.h"
#include "core/haptics/boundary/pose_boundary.h"
#include "core/tool/tool.h"

#include <vector>

namespace burin {

/// Keeps shank and holder at a distance from the stock that is left, so that the hand is pushed back before they touch
/// it (BrakeOnContact stops what touches in spite of that). The flutes may be anywhere. Only machinable material
/// counts: the part has a boundary of its own.
///
/// Distances are exact for the centre lines of the workpiece's runs, which is what a contact is determined from, too
/// (ContactCheck). The shank of a tool that doesn't turn is not in its pieces: of such a tool only the holder is kept
/// away.
///
/// The workpiece changes while the boundary is in use: `beginTick` first, then queries. Cutting only adds clearance.
class StockBoundary final : public PoseBoundary {
public:
    /// @param workpiece outlives the object @param distance mm, > 0, that shank and holder keep
    /// from the centre lines of the runs; the voxels around them reach half an edge nearer, 0.71 at their own edges
    StockBoundary(const RunVolume& workpiece, const Cutter& cutter, double distance);

    /// Call once a tick, before the first query.
    /// @param owed pending cuts (MaterialRemoval::window), which count as removed; null: none
    /// @param cuts false: the spindle is stopped, and nothing is in the way, as with BrakeOnContact
    void beginTick(const CutCache* owed, bool cuts) noexcept;
    /// Must be called after the workpiece was changed otherwise than by cutting.
    void workpieceChanged() noexcept { bricks_.forget(); }

    PoseSample at(const ToolPose& pose, double enough) noexcept override;
    double errorBound() const noexcept override { return 1e-6; }
    double spacing() const noexcept override { return workpiece_->grid().edge(); }
    double overlap() const noexcept override { return overlap_; }
    double reach() const noexcept override { return reach_; }
    std::uint64_t work() const noexcept override { return visited_ / visitsPerWork; }

private:
    PoseSample ask(const ToolPose& pose, double enough) noexcept;

    static constexpr std::uint64_t visitsPerWork = 4; ///< evaluations that take as long as one of a triangle

    const RunVolume* workpiece_;
    std::vector<RevolvedPiece> guarded_; ///< shank and holder
    double distance_, reach_, overlap_;  ///< mm
    OccupiedBricks bricks_;
    const CutCache* owed_ = nullptr;
    bool cuts_ = false;
    LineIndex nearest_; ///< scanline that was the nearest in the last query: tried first
    std::uint64_t visited_ = 0;
    NewestSample newest_;
};

} // namespace burin
