// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/polled/polling_thread.h"

#include "core/device/device_thread.h"

#include <chrono>
#include <thread>

namespace burin::polled {
namespace {

constexpr int waitMilliseconds = 20; // longest time that `stop` may have to wait

} // namespace

Result<void> PollingThread::start() {
    return thread_.start(name_, [this] { run(); });
}

std::optional<Error> PollingThread::takeFault() {
    const std::optional<DeviceFault> fault = faults_.take();
    if (!fault) return std::nullopt;
    return errorOf(*fault, name_);
}

DeviceHealth PollingThread::health() const noexcept {
    DeviceHealth health;
    health.connected = connected();
    health.readings = readings_.load(std::memory_order_relaxed);
    return health;
}

void PollingThread::run() noexcept {
    blockSignals();
    while (runs()) {
        if (device_.connect()) {
            connected_.store(true, std::memory_order_relaxed);
            receive();
            continue;
        }
        const auto until = std::chrono::steady_clock::now() + std::chrono::duration<double>(lookEvery);
        while (runs() && std::chrono::steady_clock::now() < until)
            std::this_thread::sleep_for(std::chrono::milliseconds(waitMilliseconds));
    }
    device_.disconnect();
}

/// Receives until the device is gone, or the thread has to stop.
void PollingThread::receive() noexcept {
    while (runs()) {
        const PolledDevice::Heard heard = device_.receive(waitMilliseconds);
        if (heard == PolledDevice::Heard::gone) break;
        if (heard == PolledDevice::Heard::news) readings_.fetch_add(1, std::memory_order_relaxed);
    }
    if (!runs()) return;
    device_.disconnect();
    device_.rest();
    connected_.store(false, std::memory_order_relaxed);
    faults_.raise(DeviceFault::unplugged);
}

} // namespace burin::polled
