// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/axis_map.h"

#include <array>
#include <cstdint>

namespace burin::cap {

/// Deflection of the axes of a cap or gamepad, and the pressed buttons.
struct Controls {
    /// In counts; the full scale is that of CapStylusSettings. Of a cap the first six are its displacement, full scale
    /// 350 (some units exceed it a little): x right, y towards the user, z down; then the rotations about them.
    std::array<std::int16_t, AxisMap::mostAxes> axes{};
    std::uint32_t silent = 0;           ///< axes without a reading so far, one bit each: they count as at rest
    std::uint32_t buttons = 0;          ///< bit 0: the first button
    std::array<std::uint8_t, 6> keys{}; ///< numbers of pressed buttons beyond 32, 0: none
    std::int8_t batteryPercent = -1;    ///< -1: not reported
    bool charging = false;
};

} // namespace burin::cap
