// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/input_events/reopened_port.h"

#include <algorithm>

namespace burin::input_events {

Result<ReopenedPort> ReopenedPort::open(const InputDevice& device) {
    Result<EventPort> port = EventPort::open(device.node, device.name);
    if (!port) return std::move(port).error();
    return ReopenedPort(device.id, std::move(*port));
}

bool ReopenedPort::connect() noexcept {
    if (port_) return true;
    try {
        const std::vector<InputDevice> devices = inputDevices();
        const auto found = std::ranges::find(devices, id_, &InputDevice::id);
        if (found == devices.end()) return false;
        Result<EventPort> port = EventPort::open(found->node, found->name);
        if (port) port_ = std::move(*port);
        return port_.has_value();
    } catch (const std::exception&) { // out of memory, or a folder that has gone: retried at the next attempt
        return false;
    }
}

} // namespace burin::input_events
