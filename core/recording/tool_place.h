// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/pose.h"

#include <cmath>

namespace burin {

/// mm from the setup's origin that a tool's tip can have in a recording or in a planner's moves; machines travel a
/// tenth of it, and what is worked out from places far beyond overflows.
inline constexpr double farthestTip = 1e6;

/// Whether a tool can have stood so: within `farthestTip`, its axis of unit length (within 0.001).
inline bool isToolPlace(const ToolPose& pose) noexcept {
    const auto reached = [](double coordinate) { return std::abs(coordinate) <= farthestTip; };
    return reached(pose.tip.x) && reached(pose.tip.y) && reached(pose.tip.z) &&
           std::abs(glm::length(pose.axis) - 1.0) <= 1e-3;
}

} // namespace burin
