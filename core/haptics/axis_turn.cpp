// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/axis_turn.h"

namespace burin {

const glm::dvec3& AxisFollower::turn(const glm::dvec3& wanted, double own, double period) noexcept {
    axis_ = known_ ? turnedTowards(axis_, wanted, own + speed * period) : wanted;
    known_ = true;
    return axis_;
}

} // namespace burin
