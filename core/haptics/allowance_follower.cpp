// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/allowance_follower.h"

#include <algorithm>

namespace burin {

glm::dvec3 AllowanceFollower::advance(const Proxy& proxy, const glm::dvec3& tip, double period) noexcept {
    const double step = speed * period;
    inForce_ += std::clamp(wanted_ - inForce_, -step, step);
    if (proxy.feasible(tip, inForce_)) return tip;
    // Along an edge the gradient is not unit length: a little more way than clearance is wanted.
    const glm::dvec3 out = proxy.retreat(tip, inForce_, 4.0 * step);
    limitTo(proxy.clearance(out));
    return out;
}

} // namespace burin
