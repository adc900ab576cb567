// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/input_events/input_devices.h"

#include <linux/input.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <map>
#include <optional>

namespace burin::input_events {
namespace {

namespace fs = std::filesystem;

constexpr unsigned int bitsPerWord = 8 * sizeof(long);

/// The first line of a small file in sysfs; empty if there is no such file.
std::string lineOf(const fs::path& file) {
    std::ifstream stream(file);
    std::string line;
    std::getline(stream, line);
    return line;
}

std::optional<InputKind> kindOf(const fs::path& device) {
    const std::string keys = lineOf(device / "capabilities/key"), axes = lineOf(device / "capabilities/abs");
    if (!hasBit(axes, ABS_X) || !hasBit(axes, ABS_Y)) return std::nullopt;
    if (hasBit(axes, ABS_PRESSURE) && hasBit(keys, BTN_TOOL_PEN)) return InputKind::tablet;
    if (hasBit(keys, BTN_GAMEPAD) || hasBit(keys, BTN_JOYSTICK)) return InputKind::gamepad;
    return std::nullopt;
}

/// Whether the driver of HID PID devices serves this one, or no driver at all (a device made by a program).
bool isHidPid(const fs::path& device) {
    std::error_code ignored;
    const fs::path driver = fs::read_symlink(device / "device/driver", ignored).filename();
    return driver.empty() || driver == "hid-generic" || driver == "hid-universal-pidff";
}

ForceAbilities forceOf(const fs::path& device) {
    const std::string effects = lineOf(device / "capabilities/ff");
    ForceAbilities force;
    force.rumble = hasBit(effects, FF_RUMBLE);
    force.constant = hasBit(effects, FF_CONSTANT);
    force.spring = hasBit(effects, FF_SPRING);
    force.damper = hasBit(effects, FF_DAMPER);
    force.gain = hasBit(effects, FF_GAIN);
    force.autocentre = hasBit(effects, FF_AUTOCENTER) && isHidPid(device);
    if (force.constant) force.axes = hasBit(lineOf(device / "capabilities/key"), BTN_WHEEL) ? 1 : 2;
    return force;
}

} // namespace

bool hasBit(std::string_view words, unsigned int bit) {
    std::string_view rest = words;
    for (unsigned int above = bit / bitsPerWord;; --above) {
        const std::size_t space = rest.find_last_of(' ');
        const std::string_view word = space == std::string_view::npos ? rest : rest.substr(space + 1);
        if (above == 0) {
            unsigned long value = 0;
            const auto read = std::from_chars(word.data(), word.data() + word.size(), value, 16);
            return read.ec == std::errc() && (value >> bit % bitsPerWord & 1UL) != 0;
        }
        if (space == std::string_view::npos) return false;
        rest = rest.substr(0, space);
    }
}

std::vector<InputDevice> inputDevices(const InputFolders& folders) {
    std::vector<InputDevice> found;
    std::error_code ignored;
    for (fs::directory_iterator entry(folders.classes, ignored), end; entry != end; entry.increment(ignored)) {
        const std::string event = entry->path().filename().string();
        if (!event.starts_with("event")) continue;
        const fs::path device = entry->path() / "device";
        const std::optional<InputKind> kind = kindOf(device);
        if (!kind) continue;
        std::string id = lineOf(device / "id/vendor") + ':' + lineOf(device / "id/product");
        if (const std::string serial = lineOf(device / "uniq"); !serial.empty()) id += ':' + serial;
        found.push_back({std::move(id), lineOf(device / "name"), folders.nodes / event, *kind, forceOf(device)});
    }
    // In the order in which they were plugged in, as far as that is known.
    const auto number = [](const InputDevice& device) {
        const std::string node = device.node.filename().string();
        return std::pair(node.size(), node);
    };
    std::ranges::sort(found, {}, number);
    std::map<std::string, int> seen;
    for (InputDevice& device : found)
        if (const int count = ++seen[device.id]; count > 1) device.id += ':' + std::to_string(count);
    std::ranges::sort(found, {}, &InputDevice::id);
    return found;
}

} // namespace burin::input_events
