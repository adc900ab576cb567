// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/boundary/allowance_follower.h"

#include <algorithm>

namespace burin {

void AllowanceFollower::limitTo(const ToolPose& tool) noexcept {
    const double clearance = layers_->partClearance(tool);
    if (clearance < layers_->allowance()) layers_->setAllowance(std::max(clearance, 0.0));
}

ToolPose AllowanceFollower::advance(const Proxy& proxy, const ToolPose& tool, double period) noexcept {
    const double step = speed * period, inForce = layers_->allowance();
    layers_->setAllowance(inForce + std::clamp(wanted_ - inForce, -step, step));
    if (proxy.feasible(tool)) return tool;
    // Along an edge the gradient does not have unit length, so the tool may have to move somewhat farther than the
    // missing clearance.
    const ToolPose out = proxy.retreat(tool, 4.0 * step);
    limitTo(out);
    return out;
}

} // namespace burin
