// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/force/force_limiter.h"

#include "core/geometry/pose.h"

#include <algorithm>

namespace burin {
namespace {

constexpr double smallestRise = 0.15; // N per tick
constexpr double handSpeed = 0.5;     // m/s, into a wall
constexpr double fallOverRise = 3.0;

} // namespace

ForceLimiter::ForceLimiter(double maximum, double stiffness, double period) noexcept
    : maximum_(maximum)
    , riseStep_(std::max(smallestRise, stiffness * handSpeed * period))
    , fallStep_(fallOverRise * riseStep_) {}

glm::dvec3 ForceLimiter::limit(const glm::dvec3& wanted) noexcept {
    const glm::dvec3 finite = isFinite(wanted) ? wanted : glm::dvec3(0.0);
    const glm::dvec3 bounded = clampLength(finite, maximum_);
    saturated_ = glm::dot(finite, finite) > maximum_ * maximum_;
    const bool grows = glm::dot(bounded, bounded) >= glm::dot(applied_, applied_);
    applied_ += clampLength(bounded - applied_, grows ? riseStep_ : fallStep_);
    return applied_;
}

} // namespace burin
