// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/cap/cap_mapping.h"

#include "core/device/deflection.h"

#include <algorithm>
#include <cmath>

namespace burin::cap {
namespace {

glm::dquat turnBy(const glm::dvec3& turn) noexcept { // rad, rotation vector
    const double angle = glm::length(turn);
    return angle > 0.0 ? glm::angleAxis(angle, turn / angle) : glm::dquat(1.0, 0.0, 0.0, 0.0);
}

/// From the cap's frame (y towards the user, z down) to the device's.
glm::dvec3 turned(double x, double y, double z) noexcept {
    return {x, -y, -z};
}

} // namespace

double CapMapping::response(std::int16_t counts) noexcept {
    return deflectionResponse(static_cast<double>(counts) / fullScale);
}

void CapMapping::follow(const Pose& target, double step) noexcept {
    const double share = 1.0 - std::exp(-step / lag);
    pose_.position += clampLength(share * (target.position - pose_.position), followSpeed * step);
    pose_.rotation = glm::normalize(glm::slerp(pose_.rotation, target.rotation, share));
}

const Pose& CapMapping::advance(const std::array<std::int16_t, 6>& axes, double seconds) noexcept {
    const auto at = [&axes](std::size_t axis) { return response(axes[axis]); };
    const glm::dvec3 moved = turned(at(0), at(1), at(2)), turn = turned(at(3), at(4), at(5));
    const double step = std::clamp(seconds, 0.0, longestStep);
    if (mode_ == ControlMode::position) {
        follow({reach * moved, turnBy(turnReach * turn)}, step);
        return pose_;
    }
    pose_.position = clampLength(pose_.position + topSpeed * step * moved, workspaceRadius);
    pose_.rotation = glm::normalize(turnBy(topTurn * step * turn) * pose_.rotation);
    return pose_;
}

} // namespace burin::cap
