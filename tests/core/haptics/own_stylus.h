// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/device_fault.h"
#include "core/device/stylus.h"
#include "core/haptics/loop/loop_clock.h"

#include <algorithm>
#include <atomic>
#include <functional>
#include <thread>
#include <utility>

namespace burin::test {

/// A stylus with a thread and a clock of its own, whose readings and motors a test controls. The clock is that of its
/// readings, s since `start`.
class OwnStylus final : public SelfPacedStylus {
public:
    using Read = std::function<StylusState(double time, int reading)>;
    using Drive = std::function<void(const Wrench&)>;
    using Cut = std::function<void()>;

    OwnStylus(StylusDescription description, Read read, Drive drive = {}, Cut cut = {})
        : description_(std::move(description))
        , read_(std::move(read))
        , drive_(std::move(drive))
        , cut_(std::move(cut)) {}
    ~OwnStylus() override { stop(); }
    OwnStylus(const OwnStylus&) = delete;
    OwnStylus& operator=(const OwnStylus&) = delete;

    StylusDescription description() const override { return description_; }
    Result<void> open() override { return {}; }
    void close() noexcept override { stop(); }
    void cutMotors() noexcept override {
        if (cut_) cut_();
    }
    std::optional<Error> takeFault() override { return faults.take() ? std::optional(unplugged()) : std::nullopt; }
    Result<void> start(StylusClient& client) override {
        thread_ = std::jthread([this, &client](const std::stop_token& stop) { run(client, stop); });
        return {};
    }
    void stop() noexcept override {
        if (!thread_.joinable()) return;
        thread_.request_stop();
        thread_.join();
    }

    DeviceHealth health() const noexcept override {
        DeviceHealth told;
        if (battery >= 0.0) told.batteryShare = battery;
        if (heat >= 0.0) told.motorHeat = heat;
        return told;
    }

    FaultBox faults;
    std::atomic<double> battery{-1.0}, heat{-1.0}; ///< 0 … 1; negative: not reported

private:
    Error unplugged() const { return errorOf(DeviceFault::unplugged, description_.name); }
    void run(StylusClient& client, const std::stop_token& stop) {
        client.begins();
        const std::int64_t start = now();
        const double rate = description_.rate.value > 0.0 ? description_.rate.value : 1000.0;
        std::int64_t due = start;
        for (int reading = 0; !stop.stop_requested(); ++reading) {
            sleepUntil(due);
            due = std::max(due + nanoseconds(1.0 / rate), now());
            StylusState state = read_(seconds(now() - start), reading);
            const Wrench wrench = client.tick(state);
            if (drive_) drive_(wrench);
            client.answered();
        }
        if (drive_) drive_({});
        client.ends();
    }

    StylusDescription description_;
    Read read_;
    Drive drive_;
    Cut cut_;
    std::jthread thread_;
};

} // namespace burin::test
