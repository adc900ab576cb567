// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/device/device_fault.h"
#include "core/device/stylus.h"

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>
#include <thread>

namespace burin::polled {

/// A device that is read by waiting for it. All calls come from one thread, the polling thread's.
class PolledDevice {
public:
    enum class Heard : std::uint8_t { nothing, news, gone };
    virtual ~PolledDevice() = default;
    /// Looks for the device and opens it. True: it is open, also when it was before.
    virtual bool connect() noexcept = 0;
    /// Waits for news, a while at most, and hands them to whoever reads the device.
    virtual Heard receive(int milliseconds) noexcept = 0;
    /// Also when it is not connected.
    virtual void disconnect() noexcept = 0;
    /// It was lost: nothing is pressed or pushed any more.
    virtual void rest() noexcept = 0;
};

/// Reads a device in a thread of its own, and finds it again after it was unplugged. Thread: start, stop, takeFault the
/// owner's; the rest any.
class PollingThread {
public:
    static constexpr double lookEvery = 0.5; ///< s

    /// @param device outlives the object; it is connected. @param name of it, for faults
    PollingThread(PolledDevice& device, std::string name) : device_(device), name_(std::move(name)) {}
    ~PollingThread() { stop(); }
    PollingThread(const PollingThread&) = delete;
    PollingThread& operator=(const PollingThread&) = delete;

    /// Errors: argumentInvalid (it runs), outOfMemory.
    Result<void> start();
    void stop() noexcept;
    std::optional<Error> takeFault();
    bool connected() const noexcept { return connected_.load(std::memory_order_relaxed); }
    /// Connected or not, and how often it was heard.
    DeviceHealth health() const noexcept;

private:
    void run() noexcept;
    void receive() noexcept;
    bool runs() const noexcept { return !stop_.load(std::memory_order_relaxed); }

    PolledDevice& device_;
    std::string name_;
    FaultBox faults_;
    std::atomic<std::uint64_t> readings_{0};
    std::atomic<bool> connected_{true}, stop_{false};
    std::thread thread_;
};

} // namespace burin::polled
