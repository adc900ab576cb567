// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/pose.h"

#include <cmath>

namespace burin {

/// Largest coordinate of a tool's tip in a recording or in a planner's moves, mm from the setup's origin; the travel of
/// machines is a tenth of it, and calculations with positions far beyond would overflow.
inline constexpr double farthestTip = 1e6;

/// Whether the pose is possible for a tool: within `farthestTip`, with an axis of unit length (within 0.001).
inline bool isToolPlace(const ToolPose& pose) noexcept {
    const auto reached = [](double coordinate) { return std::abs(coordinate) <= farthestTip; };
    return reached(pose.tip.x) && reached(pose.tip.y) && reached(pose.tip.z) &&
           std::abs(glm::length(pose.axis) - 1.0) <= 1e-3;
}

} // namespace burin
