// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/input_events/force_encoding.h"

#include "core/geometry/pose.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace burin::input_events {
namespace {

constexpr double fullLevel = 0x7fff, fullMagnitude = 0xffff, fullTurn = 0x10000;

/// Also for what is not a number.
double within(double share, double ceiling) noexcept {
    return share > 0.0 ? std::min(share, ceiling) : 0.0;
}

std::uint16_t magnitude(double share) noexcept {
    return static_cast<std::uint16_t>(std::lround(share * fullMagnitude));
}

/// Force towards higher readings of an axis.
double alongAxis(const glm::dvec3& force, const AxisUse& use) noexcept {
    if (use.motion < AxisMotion::x || use.motion > AxisMotion::z) return 0.0;
    const double along = force[static_cast<int>(use.motion) - static_cast<int>(AxisMotion::x)];
    return use.reversed ? -along : along;
}

std::uint16_t directionOf(const glm::dvec2& push) noexcept {
    const double turns = std::atan2(-push.x, -push.y) / (2.0 * std::numbers::pi); // -0.5 … 0.5
    return static_cast<std::uint16_t>(static_cast<std::uint32_t>(std::lround((turns + 1.0) * fullTurn)) & 0xffffU);
}

} // namespace

glm::dvec2 stickForce(const glm::dvec3& force, const AxisMap& map, int axes) noexcept {
    glm::dvec2 push(0.0);
    if (axes > 0) push.x = alongAxis(force, map.axes[0]);
    if (axes > 1) push.y = -alongAxis(force, map.axes[1]); // a stick's second axis counts towards the user
    return push;
}

EffectLevels encoded(const Assist& assist, const AxisMap& map, const AssistAbilities& abilities) noexcept {
    EffectLevels levels;
    const double ceiling = within(assist.ceiling, 1.0);
    if (!abilities.works() || ceiling == 0.0) return levels;
    levels.ceiling = magnitude(ceiling);
    if (abilities.forceAxes == 0) {
        levels.strong = magnitude(within(assist.contact, ceiling));
        levels.weak = magnitude(within(assist.load, ceiling));
        return levels;
    }
    const glm::dvec3 force = isFinite(assist.force) ? clampLength(assist.force, ceiling) : glm::dvec3(0.0);
    const glm::dvec2 push = stickForce(force, map, abilities.forceAxes);
    const double pushed = glm::length(push);
    levels.level = static_cast<std::int16_t>(std::lround(within(pushed, ceiling) * fullLevel));
    if (levels.level > 0) levels.direction = directionOf(push);
    if (abilities.rumble) levels.strong = magnitude(std::sqrt(std::max(0.0, glm::dot(force, force) - pushed * pushed)));
    return levels;
}

} // namespace burin::input_events
