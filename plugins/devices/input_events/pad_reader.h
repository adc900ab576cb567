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

/// Makes controls of the events of a gamepad or joystick. The left stick moves the tool in the plane; the right one up
/// and down, and turns it about its axis; the triggers press it down (right) and lift it (left). A joystick without a
/// second stick lifts and lowers with its hat, and turns with its twist. Until an axis has moved it counts as at rest:
/// the kernel knows no value of it before. Source of the codes: the kernel's Documentation/input/gamepad.rst. One
/// thread; no allocation, no exception after it was made.
class PadReader {
public:
    enum class Kind : std::uint8_t { none, motion, button };
    static constexpr double deadZone = 0.1; ///< share of a stick's way about its middle; what the device states if more

    explicit PadReader(const libevdev& device);

    Kind take(const input_event& event) noexcept;
    const cap::Controls& controls() const noexcept { return controls_; }
    int buttonCount() const noexcept { return static_cast<int>(buttons_.size()); }

private:
    /// What a control of the device does to one of ours.
    struct Axis {
        unsigned int code = 0;
        double low = 0.0, high = 0.0; ///< of its values
        double dead = 0.0;            ///< share
        bool oneSided = false;        ///< a trigger: at rest at its low end
        std::size_t target = 0;       ///< of Controls::axes
        double sign = 1.0;
        double value = 0.0; ///< -1 … 1 as it is now
    };
    void addAxis(const libevdev& device, unsigned int code, std::size_t target, double sign, bool oneSided = false);

    std::vector<Axis> axes_;
    std::vector<unsigned int> buttons_; ///< codes, in their order; 32 at most
    cap::Controls controls_;
};

} // namespace burin::input_events
