// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "plugins/devices/cap/controls.h"

#include <libevdev/libevdev.h>

#include <string>
#include <vector>

namespace burin::input_events {

/// Converts the events of a gamepad or joystick to controls: each of its axes is one of Controls::axes, from
/// -`fullScale` to `fullScale` over its range. Unless the user assigns them differently, the left stick moves the tool
/// in the plane; the right one moves it up and down and rotates it about its axis; the triggers press it down (right)
/// and lift it (left). A joystick without a second stick lifts and lowers the tool with its hat, and rotates it with
/// its twist. An axis counts as at rest until it has moved: the kernel knows no value of it before. Source of the
/// codes: the kernel's Documentation/input/gamepad.rst. One thread; no allocation, no exception after the construction.
class PadReader {
public:
    enum class Kind : std::uint8_t { none, motion, button };
    /// share of a stick's range about its centre; a larger value stated by the device is used instead
    static constexpr double deadZone = 0.1;
    static constexpr double fullScale = 32000.0; ///< counts

    explicit PadReader(const libevdev& device);

    Kind take(const input_event& event) noexcept;
    const cap::Controls& controls() const noexcept { return controls_; }
    int buttonCount() const noexcept { return static_cast<int>(buttons_.size()); }
    const std::vector<DeviceAxis>& axes() const noexcept { return named_; }
    const AxisMap& map() const noexcept { return map_; } ///< unless the user assigns the axes differently

private:
    /// An axis of the device.
    struct Axis {
        unsigned int code = 0;
        double low = 0.0, high = 0.0; ///< range of its values
    };
    void addAxis(const libevdev& device, unsigned int code, AxisMotion motion, bool reversed = false,
                 bool oneSided = false);
    void addAxes(const libevdev& device);

    std::vector<Axis> axes_; ///< in the order of Controls::axes
    std::vector<DeviceAxis> named_;
    AxisMap map_;
    std::vector<unsigned int> buttons_; ///< codes in ascending order; 32 at most
    cap::Controls controls_;
};

} // namespace burin::input_events
