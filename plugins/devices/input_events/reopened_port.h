// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "plugins/devices/input_events/event_port.h"
#include "plugins/devices/input_events/input_devices.h"

#include <optional>
#include <string>

namespace burin::input_events {

/// An input device that is opened again, identified by its id, after it was unplugged. One thread at a time.
class ReopenedPort {
public:
    /// Errors: those of EventPort::open.
    static Result<ReopenedPort> open(const InputDevice& device);

    bool connect() noexcept;
    void disconnect() noexcept { port_.reset(); }
    /// May only be called while it is connected.
    EventPort::Heard next(input_event& event, int milliseconds) noexcept { return port_->next(event, milliseconds); }
    const libevdev& device() const noexcept { return port_->device(); }

private:
    ReopenedPort(std::string id, EventPort port) : id_(std::move(id)), port_(std::move(port)) {}

    std::string id_;
    std::optional<EventPort> port_;
};

} // namespace burin::input_events
