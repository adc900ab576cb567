// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace burin::input_events {

enum class InputKind : std::uint8_t { gamepad, tablet };

/// What an input device can render, by the bits that the kernel shows.
struct ForceAbilities {
    bool rumble = false, constant = false, spring = false, damper = false; ///< kinds of effects
    bool gain = false;
    /// It centres its stick by itself, and that can be switched off and on again as the kernel had it. The kernel does
    /// not tell how strong it was: it is known only for the driver of HID PID devices, which sets it to the full
    /// strength when they are plugged in.
    bool autocentre = false;
    int axes = 0; ///< that a constant force can push: the kernel shows none; a joystick has two, a wheel one

    bool any() const noexcept { return rumble || constant; }
};

/// An input device of the kernel with which a tool can be moved.
struct InputDevice {
    /// vendor and product, and the serial number if it has one; ":2" for the second one of the same kind
    std::string id;
    std::string name;           ///< reported by the device
    std::filesystem::path node; ///< in /dev/input
    InputKind kind = InputKind::gamepad;
    ForceAbilities force{};
};

/// The folders in which the kernel shows its input devices.
struct InputFolders {
    std::filesystem::path classes = "/sys/class/input", nodes = "/dev/input";
};

/// The gamepads, joysticks and pen tablets that are plugged in, including those that must not be opened: their
/// abilities are readable for everyone in sysfs. Sorted by id.
std::vector<InputDevice> inputDevices(const InputFolders& folders = {});

/// Whether a bit is set in a bit field of sysfs: hexadecimal words of the machine's long, the highest first.
bool hasBit(std::string_view words, unsigned int bit);

} // namespace burin::input_events
