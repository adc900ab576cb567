// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/boundary/allowance_follower.h"
#include "core/haptics/boundary/proxy.h"
#include "core/haptics/boundary/stock_boundary.h"
#include "core/haptics/brake_on_contact.h"
#include "core/haptics/cut_tick.h"
#include "core/haptics/haptic_settings.h"
#include "core/haptics/tool_motion.h"

namespace burin {

/// Moves the tool towards the hand as far as the part, the other boundaries, and shank and holder allow. Called in the
/// haptic tick.
class ToolMover {
public:
    /// Largest angular speed of the axis, rad/s; faster than a wrist.
    static constexpr double turnSpeed = 25.0;

    /// Adds the layer of the stock if the settings ask for one: it is then the last one.
    /// @param layers, workpiece outlive the object
    /// @param columns of the tool on the workpiece's grid, which its CutTick shares; null: the tool has no solid
    ToolMover(BoundaryLayers& layers, const Tool& tool, const RunVolume& workpiece, const HapticSettings& settings,
              std::shared_ptr<const SolidColumns> columns);

    /// Places the tool at the hand's pose if that is free. Returns false if it is not.
    bool start(const ToolPose& hand, const CutTick& cut) noexcept;
    /// Pose at which a tool that has not started yet is displayed: moved away from the hand along its axis, clear of
    /// the part.
    ToolPose parkedAbove(const ToolPose& hand) noexcept;
    /// One tick. The tool's pose changes only with `arrive`. @param period s. @param cut used to query the workpiece;
    /// it is settled where a contact with material that is cut but not yet written is possible.
    ToolMotion move(const ToolPose& hand, double period, CutTick& cut) noexcept;
    /// Sets the tool's pose to the end of a motion, which may have been shortened since.
    void arrive(const ToolMotion& motion) noexcept;

    const ToolPose& pose() const noexcept { return pose_; }
    /// Takes effect gradually. @param allowance mm, >= 0
    void setAllowance(double allowance) noexcept { allowance_.want(allowance); }
    void workpieceChanged() noexcept;
    /// @param scale mm of setup per mm of device; the largest motion of the tool in a tick is proportional to it
    void setScale(double scale) noexcept;
    /// The last contact of shank or holder.
    const ShankContact& shankContact() const noexcept { return shank_; }

private:
    ToolPose wanted(const ToolPose& hand) const noexcept;
    ProxyStride stride(double period) const noexcept;
    void lookAtStock(const CutTick& cut) noexcept;
    bool barred(const ToolPose& to, CutTick& cut, ToolMotion& motion) noexcept;
    ProxyStep aroundContact(const ToolPose& standing, const ToolPose& goal, ProxyStride stride, CutTick& cut,
                            ToolMotion& motion) noexcept;

    BoundaryLayers& layers_;
    StockBoundary* stock_; ///< the last of the layers; null: none
    AxisMode axis_;
    ProxyStride::Yields yields_;
    double turnLengthAtScale1_, turnLength_ = 0.0; ///< mm
    double room_;                                  ///< mm
    double topOfWorkpiece_;                        ///< mm
    /// mm/s: slowest limit of the tool's speed at any scale, and speed of the fastest hand
    double slowestTravel_, handSpeed_;
    double travelPerSecond_ = 0.0; ///< mm/s
    double longestPeriod_;         ///< s, longest period that counts for a tick's motion
    BrakeOnContact brake_;
    Proxy proxy_;
    AllowanceFollower allowance_;
    ToolPose pose_;
    ShankContact shank_;
};

} // namespace burin
