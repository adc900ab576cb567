// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"

#include <libevdev/libevdev.h>

#include <filesystem>
#include <memory>

namespace burin::input_events {

struct FreeDevice {
    void operator()(libevdev* device) const noexcept { libevdev_free(device); }
};
using DeviceHandle = std::unique_ptr<libevdev, FreeDevice>;

/// An open input device. One thread at a time.
class EventPort {
public:
    enum class Heard : std::uint8_t { nothing, event, gone };

    /// Errors: deviceNotFound, deviceNotAllowed, deviceFault. @param name name of the device, for errors
    static Result<EventPort> open(const std::filesystem::path& node, const std::string& name);
    EventPort(EventPort&& other) noexcept;
    EventPort& operator=(EventPort&& other) noexcept;
    EventPort(const EventPort&) = delete;
    EventPort& operator=(const EventPort&) = delete;
    ~EventPort();

    /// Returns the next event; waits for it, up to a time limit. If events were lost in the kernel, it returns events
    /// that lead from the last reported state to the current one.
    Heard next(input_event& event, int milliseconds) noexcept;
    const libevdev& device() const noexcept { return *device_; }

private:
    EventPort(int file, DeviceHandle device) noexcept : file_(file), device_(std::move(device)) {}

    int file_ = -1;
    DeviceHandle device_;
    bool catchesUp_ = false; ///< events were lost; the state is being synchronised
};

} // namespace burin::input_events
