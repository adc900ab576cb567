// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/device_fault.h"
#include "core/device/stylus.h"
#include "plugins/devices/force_dimension/dhd_api.h"

#include <atomic>
#include <memory>
#include <string>
#include <thread>

namespace burin::forcedimension {

/// What to do with a device whose encoders are not initialised after it was switched on.
enum class Initialisation { refuse, byItself };

/// A Force Dimension device, or another one that libdrd drives. The loop calls it: it reads and writes in the same
/// tick.
///
/// The device's own protections are kept: the speed above which it brakes, and a watchdog of 20 ms that switches its
/// forces off when nothing is written. Forces that the device switched off come back only when the cause is gone; the
/// readings in between are not valid, so that Burin's forces fade in. A device that was unplugged is searched for twice
/// a second by a separate thread. Threads as for Stylus; `cutMotors` on any thread.
class DhdStylus final : public Stylus {
public:
    static constexpr unsigned char watchdog = 160;   ///< times dhdWatchdogTick: 20 ms
    static constexpr int failuresUntilLost = 20;     ///< consecutive failed readings
    static constexpr int readingsBetweenChecks = 10; ///< of the device's state
    static constexpr double retryAfter = 0.5;        ///< s from the device switching its forces off to the next attempt
    static constexpr double lookEvery = 0.5;         ///< s, interval of the searches

    /// Opens the device. Errors: deviceNotFound, deviceIncompatible (a model whose limits are not known).
    static Result<std::unique_ptr<Stylus>> connect(const DhdApi& api, DhdId id, Initialisation initialisation);
    /// @param id of the opened device @param type dhdGetSystemType
    DhdStylus(const DhdApi& api, DhdId id, int type, Initialisation initialisation, StylusDescription description);
    ~DhdStylus() override;
    DhdStylus(const DhdStylus&) = delete;
    DhdStylus& operator=(const DhdStylus&) = delete;

    StylusDescription description() const override { return description_; }
    /// May take some ten seconds if the device initialises itself. Errors: deviceFault, outOfMemory.
    Result<void> open() override;
    void close() noexcept override;
    std::optional<Error> takeFault() override;
    DeviceHealth health() const noexcept override;
    void cutMotors() noexcept override;
    StylusState read(double time) noexcept override;
    void write(const Wrench& wrench) noexcept override;

private:
    Result<void> initialise();
    void prepare() noexcept;
    void enableForces() noexcept;
    bool checkState(double time) noexcept;
    void lose() noexcept;
    void reconnectWhenLost() noexcept;
    void connectAgain() noexcept;
    Error refusal(TextId reason) const { return {ErrorCode::deviceFault, description_.name, {}, reason.text}; }

    const DhdApi& api_;
    DhdId id_;
    int type_;
    Initialisation initialisation_;
    StylusDescription description_;
    bool wrist_ = false;
    FaultBox faults_;
    std::atomic<std::uint64_t> readings_{0};
    std::atomic<bool> lost_{false}, stop_{false};
    std::atomic<unsigned int> cuts_{0};
    std::thread reconnecting_;
    bool isOpen_ = false;
    bool closed_ = false; ///< closed in the library while it is lost; used by the reconnecting thread while that runs

    unsigned int cutsAtRead_ = 0, cutsSeen_ = 0; ///< this member and the following belong to the haptic thread
    int failures_ = 0, reads_ = 0;
    bool forcesOff_ = false, valid_ = false;
    double triedAt_ = 0.0;
};

} // namespace burin::forcedimension
