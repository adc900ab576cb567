// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/input_events/pen_mapping.h"

#include "core/device/deflection.h"

#include <algorithm>
#include <cmath>

namespace burin::input_events {
namespace {

/// The rotation from upright to a tilt to the right and away from the user.
glm::dquat leaning(double x, double y) noexcept {
    const double lean = std::hypot(x, y);
    if (!(lean > 1e-6)) return {1.0, 0.0, 0.0, 0.0};
    // About the horizontal axis perpendicular to the direction of the tilt.
    return glm::angleAxis(std::min(lean, PenMapping::mostLean), glm::dvec3(-y, x, 0.0) / lean);
}

} // namespace

const Pose& PenMapping::advance(const Pen& pen, double seconds) noexcept {
    const double step = std::clamp(seconds, 0.0, longestStep), share = 1.0 - std::exp(-step / lag);
    const bool touches = (pen.buttons & 1U) != 0;
    const glm::dvec3 target(pen.x, pen.y, touches ? -depth * pen.pressure : lift);
    pose_.position += clampLength(share * (target - pose_.position), followSpeed * step);
    pose_.rotation = glm::normalize(glm::slerp(pose_.rotation, leaning(pen.leanX, pen.leanY), share));
    return pose_;
}

} // namespace burin::input_events
