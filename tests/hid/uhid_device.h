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

/// What a device tells the kernel when it is plugged in.
struct UhidIdentity {
    std::string name, serial;
    std::uint16_t vendor = 0, product = 0;
    Report descriptor;
};

/// A HID device that the kernel believes in, made with /dev/uhid: what is sent here comes out of its hidraw node, and
/// what is written there comes in here. Gone from the bus when the object is.
class UhidDevice {
public:
    /// What the host asked of it; on the device's own thread.
    struct Handlers {
        std::function<void(const Report&)> output = [](const Report&) {};
        std::function<Report(std::uint8_t)> feature; ///< answer to GET_REPORT; empty: it has none
    };
    UhidDevice(const UhidIdentity& identity, Handlers handlers);
    ~UhidDevice();
    UhidDevice(const UhidDevice&) = delete;
    UhidDevice& operator=(const UhidDevice&) = delete;

    /// An input report with its id. False when the kernel refused it. Any thread.
    bool send(std::span<const std::uint8_t> report);

private:
    void run(const std::stop_token& stop);

    int file_ = -1;
    Handlers handlers_;
    std::mutex writing_;
    std::jthread thread_;
};

} // namespace burin::test
