// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/boundary/boundary_layers.h"
#include "core/haptics/boundary/proxy.h"

namespace burin {

/// Changes the part's allowance without a kick: the boundary grows or shrinks at a bounded speed and takes the proxy
/// along. Where part or other layers leave no room for a larger allowance, the boundary stops growing.
class AllowanceFollower {
public:
    static constexpr double speed = 5.0; ///< mm/s

    /// @param layers outlive the object
    AllowanceFollower(BoundaryLayers& layers, double allowance) noexcept : layers_(&layers), wanted_(allowance) {
        settle();
    }

    /// @param allowance mm; what is negative or not a number changes nothing.
    void want(double allowance) noexcept {
        if (allowance >= 0.0) wanted_ = allowance;
    }
    /// At once: there is no proxy yet that it could push.
    void settle() noexcept { layers_->setAllowance(wanted_); }
    /// The tool was held where it keeps no more than this: the allowance is no greater.
    void limitTo(const ToolPose& tool) noexcept;

    /// One tick. @return where the boundary leaves the proxy; feasible afterwards unless another layer is not.
    ToolPose advance(const Proxy& proxy, const ToolPose& tool, double period) noexcept;

private:
    BoundaryLayers* layers_;
    double wanted_;
};

} // namespace burin
