// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/cap/cap_mapping.h"

#include "core/base/text.h"
#include "core/device/deflection.h"

#include <algorithm>
#include <cmath>

namespace burin::cap {
namespace {

glm::dquat turnBy(const glm::dvec3& turn) noexcept { // rad, rotation vector
    const double angle = glm::length(turn);
    return angle > 0.0 ? glm::angleAxis(angle, turn / angle) : glm::dquat(1.0, 0.0, 0.0, 0.0);
}

} // namespace

std::vector<DeviceAxis> capAxes() {
    const TextId names[] = {BURIN_TEXT("Device", "right"),         BURIN_TEXT("Device", "towards the user"),
                            BURIN_TEXT("Device", "down"),          BURIN_TEXT("Device", "tilt back and forth"),
                            BURIN_TEXT("Device", "tilt sideways"), BURIN_TEXT("Device", "twist")};
    std::vector<DeviceAxis> axes;
    for (const TextId& name : names) axes.push_back({name.text});
    return axes;
}

AxisMap capMap() {
    AxisMap map;
    for (std::size_t i = 0; i < motionCount; ++i) {
        const bool alongX = i % 3 == 0;
        map.axes[i] = {static_cast<AxisMotion>(i + 1), !alongX, 1.0, CapMapping::deadZone};
    }
    return map;
}

std::array<double, AxisMap::mostAxes> readingsOf(const std::array<std::int16_t, AxisMap::mostAxes>& counts,
                                                 double fullScale) noexcept {
    std::array<double, AxisMap::mostAxes> readings{};
    for (std::size_t i = 0; i < counts.size(); ++i) readings[i] = counts[i] / fullScale;
    return readings;
}

void CapMapping::follow(const Pose& target, double step) noexcept {
    const double share = 1.0 - std::exp(-step / lag);
    pose_.position += clampLength(share * (target.position - pose_.position), followSpeed * step);
    pose_.rotation = glm::normalize(glm::slerp(pose_.rotation, target.rotation, share));
}

const Pose& CapMapping::advance(const MotionShares& motions, double seconds) noexcept {
    const auto at = [&motions](std::size_t motion) { return deflectionCurve(motions[motion]); };
    const glm::dvec3 moved(at(0), at(1), at(2)), turn(at(3), at(4), at(5));
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
