// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "plugins/devices/openhaptics/hd_api.h"

#include <functional>
#include <mutex>
#include <string>

namespace burin::openhaptics {

/// The only scheduler of libHD, which serves all devices of the process: its thread calls each device's callback 1000
/// times a second. Devices are connected and disconnected only while it is stopped, so that other devices render no
/// force during that moment. Functions may be called on any thread except the scheduler's own.
class HdScheduler {
public:
    static constexpr unsigned long rate = 1000; ///< Hz

    explicit HdScheduler(const HdApi& api) : api_(api) {}

    /// Connects a device and makes it the current one. @param prepare called while the scheduler is stopped, with the
    /// device as the current one. Errors: those of connectionError, and of `prepare`, which disconnects it again.
    Result<HdHandle> connect(const std::string& name, const std::function<Result<void>()>& prepare);
    void disconnect(HdHandle handle) noexcept;
    /// The first callback starts the scheduler, the last one stops it.
    HdScheduled add(HdCallback callback, void* self) noexcept;
    /// @param done whether the callback has returned hdDone: the library has removed it by itself then
    void remove(HdScheduled scheduled, bool done) noexcept;

private:
    void pause() noexcept;
    void goOn() noexcept;

    const HdApi& api_;
    std::mutex mutex_;
    int callbacks_ = 0;
};

} // namespace burin::openhaptics
