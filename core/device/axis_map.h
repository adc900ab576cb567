// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace burin {

/// What an axis of a device moves. Device frame: along x (right), y (away from the user), z (up); rotations about them,
/// right-handed.
enum class AxisMotion : std::uint8_t { none, x, y, z, a, b, c };
inline constexpr std::size_t motionCount = 6; ///< without `none`

/// What a button of a device does. The driver does the first two, the others are left to the window.
enum class ButtonAction : std::uint8_t {
    none,
    mill, ///< the spindle turns while it is pressed
    lift, ///< the tool rises while it is pressed, and does not cut
    undo,
    redo,
    clutch, ///< the clutch changes with each press
    recentre,
    levelAbove,
    levelBelow,
    edge, ///< the guide along the nearest edge
    fit
};

/// An axis that a device has.
struct DeviceAxis {
    std::string name;      ///< English, context "Device"; unique among the axes of the device
    bool springs = true;   ///< returns to its rest when it is released; otherwise it stays where it is
    bool oneSided = false; ///< rests at the lower end of its range
};

/// The assignment and calibration of an axis. Readings of the axis are shares of its nominal range, -1 … 1.
struct AxisUse {
    AxisMotion motion = AxisMotion::none;
    bool reversed = false;
    double gain = 1.0;                         ///< share of the full motion at full deflection, 0.05 … 10
    double deadZone = 0.0;                     ///< share of the deflection that has no effect, 0 … 0.5
    double low = -1.0, rest = 0.0, high = 1.0; ///< readings at the ends and at rest, ascending
    friend bool operator==(const AxisUse&, const AxisUse&) = default;
};

/// The assignment of all axes and buttons of a device. Plain data: the thread that reads the device has a copy.
struct AxisMap {
    static constexpr std::size_t mostAxes = 12, mostButtons = 32;
    std::array<AxisUse, mostAxes> axes;
    std::array<ButtonAction, mostButtons> buttons{ButtonAction::mill};
    friend bool operator==(const AxisMap&, const AxisMap&) = default;
};

/// The newest readings of a device's axes and buttons.
struct AxisReading {
    std::array<double, AxisMap::mostAxes> values{}; ///< share of the nominal range, about -1 … 1
    std::uint32_t buttons = 0;                      ///< bit 0: the first button
};

// Pure functions without allocation, for the thread that reads the device.

/// The calibrated deflection of an axis times its gain, -1 … 1: 0 at rest and in the dead zone, ± gain at the ends, in
/// between linear.
double shareOf(const AxisUse& use, double reading) noexcept;

/// The share of each motion, -1 … 1, in the order of AxisMotion: the sum of the axes that are assigned to it.
using MotionShares = std::array<double, motionCount>;
MotionShares motionsOf(const AxisMap& map, const std::array<double, AxisMap::mostAxes>& readings) noexcept;

/// The buttons as the session understands them. Bit 0: a button that mills is pressed, unless one that lifts is as
/// well. The other bits are those of the device, except that the first button, if it doesn't mill, has the bit of the
/// first one that does.
std::uint32_t sessionButtons(const AxisMap& map, std::uint32_t pressed) noexcept;
/// The number of the button, from 0, that has a bit of `sessionButtons`: the inverse for bits other than 0.
std::size_t buttonOfBit(const AxisMap& map, std::size_t bit) noexcept;
/// Whether a button that lifts is pressed.
bool liftPressed(const AxisMap& map, std::uint32_t pressed) noexcept;

} // namespace burin
