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

/// What to do with a device whose encoders know nothing after it was switched on.
enum class Initialisation { refuse, byItself };

/// A device of Force Dimension, or one that libdrd drives. The loop calls it: it reads and writes in the same tick.
///
/// Its own guards stay as they are: the speed from which it brakes, and a watchdog of 20 ms that takes its forces away
/// when nobody writes. Forces that it switched off come back only when its cause is gone, through readings that are not
/// valid meanwhile, so that ours fade in. A device that was unplugged is looked for twice a second by a thread that
/// only does that. Thread: as Stylus says; `cutMotors` any.
class DhdStylus final : public Stylus {
public:
    static constexpr unsigned char watchdog = 160;   ///< times dhdWatchdogTick: 20 ms
    static constexpr int failuresUntilLost = 20;     ///< readings in a row
    static constexpr int readingsBetweenChecks = 10; ///< at its state
    static constexpr double retryAfter = 0.5;        ///< s from a cut by the device to the next try
    static constexpr double lookEvery = 0.5;         ///< s

    /// Opens the device. Errors: deviceNotFound, deviceIncompatible (a model whose limits are not known).
    static Result<std::unique_ptr<Stylus>> connect(const DhdApi& api, DhdId id, Initialisation initialisation);
    /// @param id open @param type dhdGetSystemType
    DhdStylus(const DhdApi& api, DhdId id, int type, Initialisation initialisation, StylusDescription description);
    ~DhdStylus() override;
    DhdStylus(const DhdStylus&) = delete;
    DhdStylus& operator=(const DhdStylus&) = delete;

    StylusDescription description() const override { return description_; }
    /// May take some ten seconds where the device initialises itself. Errors: deviceFault, outOfMemory.
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
    bool closed_ = false; ///< in the library, while it is lost; the reconnecting thread's while that runs

    unsigned int cutsAtRead_ = 0, cutsSeen_ = 0; ///< from here on the loop's
    int failures_ = 0, reads_ = 0;
    bool forcesOff_ = false, valid_ = false;
    double triedAt_ = 0.0;
};

} // namespace burin::forcedimension
