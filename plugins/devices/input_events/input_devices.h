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

/// An input device of the kernel with which a tool can be moved.
struct InputDevice {
    /// vendor and product, and the serial number if it has one; ":2" for the second one of the same kind
    std::string id;
    std::string name;           ///< reported by the device
    std::filesystem::path node; ///< in /dev/input
    InputKind kind = InputKind::gamepad;
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
