// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <mutex>
#include <span>
#include <string>
#include <thread>
#include <vector>

namespace burin::test {

using Report = std::vector<std::uint8_t>;

/// The data that a device gives the kernel when it is plugged in.
struct UhidIdentity {
    std::string name, serial;
    std::uint16_t vendor = 0, product = 0;
    Report descriptor;
};

/// A HID device simulated with /dev/uhid, which the kernel treats like real hardware: reports sent here arrive at its
/// hidraw node, and reports written there arrive here. It is unplugged when the object is destroyed.
class UhidDevice {
public:
    /// Requests of the host; called on the device's own thread.
    struct Handlers {
        std::function<void(const Report&)> output = [](const Report&) {};
        std::function<Report(std::uint8_t)> feature; ///< answer to GET_REPORT; empty: no feature report
    };
    UhidDevice(const UhidIdentity& identity, Handlers handlers);
    ~UhidDevice();
    UhidDevice(const UhidDevice&) = delete;
    UhidDevice& operator=(const UhidDevice&) = delete;

    /// Sends an input report with its id. False if the kernel refused it. Thread-safe.
    bool send(std::span<const std::uint8_t> report);

private:
    void run(const std::stop_token& stop);

    int file_ = -1;
    Handlers handlers_;
    std::mutex writing_;
    std::jthread thread_;
};

} // namespace burin::test
