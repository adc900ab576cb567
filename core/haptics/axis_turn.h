// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/angle.h"

namespace burin {

/// A tool axis that follows a requested axis exactly, but rotates no faster than a hand would where the requested axis
/// jumps. Called in the haptic tick.
class AxisFollower {
public:
    static constexpr double speed = 2.0; ///< rad/s, in addition to the hand's own rotation

    void forget() noexcept { known_ = false; }
    const glm::dvec3& axis() const noexcept { return axis_; }
    /// @param wanted the requested axis, unit. @param own rad that the hand has rotated in this tick. @param period s
    const glm::dvec3& turn(const glm::dvec3& wanted, double own, double period) noexcept;

private:
    glm::dvec3 axis_{0.0};
    bool known_ = false;
};

} // namespace burin
