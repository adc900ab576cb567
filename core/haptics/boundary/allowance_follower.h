// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/boundary/boundary_layers.h"
#include "core/haptics/boundary/proxy.h"

namespace burin {

/// Changes the part's allowance without a jump of the force: the boundary grows or shrinks at a bounded speed and moves
/// the proxy along. If the part or other layers leave no room for a larger allowance, the boundary stops growing.
class AllowanceFollower {
public:
    static constexpr double speed = 5.0; ///< mm/s

    /// @param layers outlive the object
    AllowanceFollower(BoundaryLayers& layers, double allowance) noexcept : layers_(&layers), wanted_(allowance) {
        settle();
    }

    /// Requests an allowance. @param allowance mm; negative values and NaN change nothing.
    void want(double allowance) noexcept {
        if (allowance >= 0.0) wanted_ = allowance;
    }
    /// Applies the requested allowance at once, before there is a proxy that it could push.
    void settle() noexcept { layers_->setAllowance(wanted_); }
    /// Reduces the allowance to the clearance of the tool's pose, if that is smaller.
    void limitTo(const ToolPose& tool) noexcept;

    /// One tick. @return the pose of the proxy at the changed boundary; feasible unless another layer makes it
    /// infeasible.
    ToolPose advance(const Proxy& proxy, const ToolPose& tool, double period) noexcept;

private:
    BoundaryLayers* layers_;
    double wanted_;
};

} // namespace burin
