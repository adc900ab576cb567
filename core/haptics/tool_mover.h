// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/boundary/allowance_follower.h"
#include "core/haptics/boundary/proxy.h"
#include "core/haptics/brake_on_contact.h"
#include "core/haptics/cut_tick.h"
#include "core/haptics/haptic_settings.h"
#include "core/haptics/tool_motion.h"

namespace burin {

/// Moves the tool towards the hand as far as the part and its other bounds, and shank and holder, allow. Tick code.
class ToolMover {
public:
    /// rad/s that the axis turns at most, faster than a wrist.
    static constexpr double turnSpeed = 25.0;

    /// @param layers outlive the object. @param grid of the workpiece
    ToolMover(BoundaryLayers& layers, const Tool& tool, const Grid& grid, const HapticSettings& settings);

    /// Takes the tool up where the hand is, if nothing is in its way there.
    bool start(const ToolPose& hand, const CutTick& cut) noexcept;
    /// Where a tool that has not started is shown: away from the hand along its axis, clear of the part.
    ToolPose parkedAbove(const ToolPose& hand) noexcept;
    /// One tick. The tool is where it was until `arrive`. @param period s. @param cut what the workpiece is asked
    /// through; it is settled where a contact may be with what is cut but not yet written.
    ToolMotion move(const ToolPose& hand, double period, CutTick& cut) noexcept;
    /// The tool has arrived where a motion leads, which may have been cut short since.
    void arrive(const ToolMotion& motion) noexcept;

    const ToolPose& pose() const noexcept { return pose_; }
    /// Takes effect over some ticks. @param allowance mm, >= 0
    void setAllowance(double allowance) noexcept { allowance_.want(allowance); }
    void workpieceChanged() noexcept { brake_.workpieceChanged(); }
    /// @param scale mm of setup per mm of device: how far the tool may travel in a tick goes with it
    void setScale(double scale) noexcept;
    /// What shank or holder touched last.
    const ShankContact& shankContact() const noexcept { return shank_; }

private:
    ToolPose wanted(const ToolPose& hand) const noexcept;
    ProxyStride stride(double period) const noexcept;
    bool barred(const ToolPose& to, CutTick& cut, ToolMotion& motion) noexcept;
    ProxyStep aroundContact(const ToolPose& standing, const ToolPose& goal, ProxyStride stride, CutTick& cut,
                            ToolMotion& motion) noexcept;

    BoundaryLayers& layers_;
    AxisMode axis_;
    ProxyStride::Yields yields_;
    double turnLengthAtScale1_, turnLength_ = 0.0; ///< mm
    double room_;                                  ///< mm
    double topOfWorkpiece_;                        ///< mm
    double slowestTravel_, handSpeed_;             ///< mm/s: of the tool at any scale, and of the fastest hand
    double travelPerSecond_ = 0.0;                 ///< mm/s
    double longestPeriod_;                         ///< s that a tick's travel is allowed for
    BrakeOnContact brake_;
    Proxy proxy_;
    AllowanceFollower allowance_;
    ToolPose pose_;
    ShankContact shank_;
};

} // namespace burin
