// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/angle.h"

namespace burin {

/// `from`, turned towards `to` by at most an angle, rad. All of unit length.
glm::dvec3 turnedTowards(const glm::dvec3& from, const glm::dvec3& to, double most) noexcept;

/// A tool's axis that follows a wanted one exactly, but turns no faster than a hand where that one jumps. Tick code.
class AxisFollower {
public:
    static constexpr double speed = 2.0; ///< rad/s, beyond the hand's own turning

    void forget() noexcept { known_ = false; }
    const glm::dvec3& axis() const noexcept { return axis_; }
    /// @param wanted unit. @param own rad that the hand has turned in this tick. @param period s
    const glm::dvec3& turn(const glm::dvec3& wanted, double own, double period) noexcept;

private:
    glm::dvec3 axis_{0.0};
    bool known_ = false;
};

} // namespace burin
