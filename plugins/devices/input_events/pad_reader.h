// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "plugins/devices/cap/controls.h"

#include <libevdev/libevdev.h>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace burin::input_events {

/// Converts the events of a gamepad or joystick to controls. The left stick moves the tool in the plane; the right one
/// moves it up and down and rotates it about its axis; the triggers press it down (right) and lift it (left). A
/// joystick without a second stick lifts and lowers the tool with its hat, and rotates it with its twist. An axis
/// counts as at rest until it has moved: the kernel knows no value of it before. Source of the codes: the kernel's
/// Documentation/input/gamepad.rst. One thread; no allocation, no exception after the construction.
class PadReader {
public:
    enum class Kind : std::uint8_t { none, motion, button };
    /// share of a stick's range about its centre; a larger value stated by the device is used instead
    static constexpr double deadZone = 0.1;

    explicit PadReader(const libevdev& device);

    Kind take(const input_event& event) noexcept;
    const cap::Controls& controls() const noexcept { return controls_; }
    int buttonCount() const noexcept { return static_cast<int>(buttons_.size()); }

private:
    /// The assignment of an axis of the device to one of the controls.
    struct Axis {
        unsigned int code = 0;
        double low = 0.0, high = 0.0; ///< range of its values
        double dead = 0.0;            ///< dead zone, share
        bool oneSided = false;        ///< a trigger: at rest at its low end
        std::size_t target = 0;       ///< index in Controls::axes
        double sign = 1.0;
        double value = 0.0; ///< -1 … 1, current value
    };
    void addAxis(const libevdev& device, unsigned int code, std::size_t target, double sign, bool oneSided = false);

    std::vector<Axis> axes_;
    std::vector<unsigned int> buttons_; ///< codes in ascending order; 32 at most
    cap::Controls controls_;
};

} // namespace burin::input_events
