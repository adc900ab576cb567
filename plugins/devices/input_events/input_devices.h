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

/// An input device of the kernel's that a tool can be moved with.
struct InputDevice {
    std::string id;   ///< vendor and product, its serial number where it has one; ":2" for the second of the same
    std::string name; ///< as the device calls itself
    std::filesystem::path node; ///< in /dev/input
    InputKind kind = InputKind::gamepad;
};

/// Where the kernel shows its input devices.
struct InputFolders {
    std::filesystem::path classes = "/sys/class/input", nodes = "/dev/input";
};

/// The gamepads, joysticks and pen tablets that are plugged in, also those that may not be opened: what they can do
/// stands in sysfs for everyone. By id.
std::vector<InputDevice> inputDevices(const InputFolders& folders = {});

/// Whether a bit is set in one of sysfs' bit fields: hexadecimal words of the machine's long, the highest first.
bool hasBit(std::string_view words, unsigned int bit);

} // namespace burin::input_events
