// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/proxy.h"

namespace burin {

/// Changes the allowance without a kick: the boundary grows or shrinks at a bounded speed and takes the proxy along.
/// Where the part leaves no room for a larger allowance, the boundary stops growing.
class AllowanceFollower {
public:
    static constexpr double speed = 5.0; ///< mm/s

    explicit AllowanceFollower(double allowance) noexcept : wanted_(allowance), inForce_(allowance) {}

    /// @param allowance mm; what is negative or not a number changes nothing.
    void want(double allowance) noexcept {
        if (allowance >= 0.0) wanted_ = allowance;
    }
    /// At once: there is no proxy yet that it could push.
    void settle() noexcept { inForce_ = wanted_; }
    /// The tool was held where it keeps no more than this clearance, mm.
    void limitTo(double clearance) noexcept {
        if (clearance < inForce_) inForce_ = clearance;
    }
    double inForce() const noexcept { return inForce_; }

    /// One tick. @return where the boundary leaves the proxy, mm; feasible with `inForce` afterwards.
    glm::dvec3 advance(const Proxy& proxy, const glm::dvec3& tip, double period) noexcept;

private:
    double wanted_, inForce_;
};

} // namespace burin
