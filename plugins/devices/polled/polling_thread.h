// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/device/device_fault.h"
#include "core/device/driver_thread.h"
#include "core/device/stylus.h"

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>

namespace burin::polled {

/// A device that is read by waiting for data. All calls come from the polling thread.
class PolledDevice {
public:
    enum class Heard : std::uint8_t { nothing, news, gone };
    virtual ~PolledDevice() = default;
    /// Searches for the device and opens it. Returns true if it is open, also if it was open before.
    virtual bool connect() noexcept = 0;
    /// Waits for data, up to a time limit, and passes it on to the users of the device.
    virtual Heard receive(int milliseconds) noexcept = 0;
    /// May also be called when it is not connected.
    virtual void disconnect() noexcept = 0;
    /// Called when the device was lost: resets all inputs to rest.
    virtual void rest() noexcept = 0;
};

/// Reads a device in a thread of its own, and finds it again after it was unplugged. start, stop and takeFault are
/// called on the owner's thread, all others on any thread.
class PollingThread {
public:
    static constexpr double lookEvery = 0.5; ///< s, interval of the searches

    /// @param device outlives the object; already connected. @param name name of the device, for faults
    PollingThread(PolledDevice& device, std::string name) : device_(device), name_(std::move(name)) {}
    ~PollingThread() { stop(); }
    PollingThread(const PollingThread&) = delete;
    PollingThread& operator=(const PollingThread&) = delete;

    /// Errors: argumentInvalid (already running), outOfMemory.
    Result<void> start();
    void stop() noexcept { thread_.stop(); }
    std::optional<Error> takeFault();
    bool connected() const noexcept { return connected_.load(std::memory_order_relaxed); }
    /// Connection state, and the number of readings received.
    DeviceHealth health() const noexcept;

private:
    void run() noexcept;
    void receive() noexcept;
    bool runs() const noexcept { return thread_.runs(); }

    PolledDevice& device_;
    std::string name_;
    FaultBox faults_;
    std::atomic<std::uint64_t> readings_{0};
    std::atomic<bool> connected_{true};
    DriverThread thread_;
};

} // namespace burin::polled
