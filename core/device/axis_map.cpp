// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/device/axis_map.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

/// The buttons with an action, one bit each.
std::uint32_t buttonsWith(const AxisMap& map, ButtonAction action) noexcept {
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < map.buttons.size(); ++i)
        if (map.buttons[i] == action) bits |= 1U << i;
    return bits;
}

/// The first button that mills; 0 if none does.
std::size_t millButton(const AxisMap& map) noexcept {
    const auto found = std::ranges::find(map.buttons, ButtonAction::mill);
    return found == map.buttons.end() ? 0 : static_cast<std::size_t>(found - map.buttons.begin());
}

} // namespace

double shareOf(const AxisUse& use, double reading) noexcept {
    const double off = reading - use.rest;
    const double range = off >= 0.0 ? use.high - use.rest : use.rest - use.low;
    if (!(range > 0.0)) return 0.0;
    const double pushed = std::min(std::abs(off) / range, 1.0);
    const double beyond = std::max(0.0, pushed - use.deadZone) / (1.0 - use.deadZone);
    const double share = std::min(use.gain * beyond, 1.0);
    return (off < 0.0) != use.reversed ? -share : share;
}

MotionShares motionsOf(const AxisMap& map, const std::array<double, AxisMap::mostAxes>& readings) noexcept {
    MotionShares motions{};
    for (std::size_t i = 0; i < readings.size(); ++i) {
        const AxisUse& use = map.axes[i];
        if (use.motion != AxisMotion::none)
            motions[static_cast<std::size_t>(use.motion) - 1] += shareOf(use, readings[i]);
    }
    for (double& motion : motions) motion = std::clamp(motion, -1.0, 1.0);
    return motions;
}

std::uint32_t sessionButtons(const AxisMap& map, std::uint32_t pressed) noexcept {
    const std::uint32_t mills = buttonsWith(map, ButtonAction::mill);
    std::uint32_t bits = pressed & ~mills & ~1U;
    const std::size_t moved = millButton(map);
    if (moved != 0 && (pressed & 1U) != 0) bits |= 1U << moved; // button 0 does not mill
    if ((pressed & mills) != 0 && !liftPressed(map, pressed)) bits |= 1U;
    return bits;
}

std::size_t buttonOfBit(const AxisMap& map, std::size_t bit) noexcept {
    const std::size_t moved = millButton(map);
    return bit == moved ? 0 : bit;
}

bool liftPressed(const AxisMap& map, std::uint32_t pressed) noexcept {
    return (pressed & buttonsWith(map, ButtonAction::lift)) != 0;
}

} // namespace burin
