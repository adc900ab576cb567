// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/device_fault.h"
#include "core/device/stylus.h"
#include "plugins/devices/openhaptics/hd_api.h"
#include "plugins/devices/openhaptics/hd_errors.h"
#include "plugins/devices/openhaptics/hd_scheduler.h"

#include <atomic>
#include <memory>
#include <string>
#include <thread>

namespace burin::openhaptics {

/// libHD and its objects that exist once per process; outlives all styluses.
struct HdLibrary {
    explicit HdLibrary(const HdApi& functions) : api(functions), scheduler(api), errors(api) {}
    HdApi api;
    HdScheduler scheduler;
    HdErrors errors;
};

/// A device of 3D Systems. The library's scheduler calls it: each call is one frame of the device, in which the pose is
/// read, the client is called, and the force is set, so that the only delay between them is the client's own.
///
/// An error of the library switches the force off (the readings are not valid) until no error has occurred for some
/// time. A device that was unplugged is searched for twice a second by a separate thread. Threads as for
/// SelfPacedStylus.
class HdStylus final : public SelfPacedStylus {
public:
    static constexpr double calmAfter = 0.1;  ///< s without an error after which readings are valid again
    static constexpr double lookEvery = 0.5;  ///< s, interval of the searches
    static constexpr double stopWithin = 1.0; ///< s for the scheduler to call a last frame

    /// Connects a device. Errors: those of HdScheduler::connect and describeCurrent.
    static Result<std::unique_ptr<SelfPacedStylus>> connect(std::shared_ptr<HdLibrary> library,
                                                            const std::string& name);
    /// @param calibrated result of calibrateCurrent
    HdStylus(std::shared_ptr<HdLibrary> library, std::string name, HdHandle handle, StylusDescription description,
             Result<void> calibrated);
    ~HdStylus() override;
    HdStylus(const HdStylus&) = delete;
    HdStylus& operator=(const HdStylus&) = delete;

    StylusDescription description() const override { return description_; }
    /// Errors: deviceFault (its pose is not meaningful until the pen was in its inkwell).
    Result<void> open() override { return calibrated_; }
    void close() noexcept override { stop(); }
    std::optional<Error> takeFault() override;
    DeviceHealth health() const noexcept override;
    /// Switches the device's forces off. If a frame is in progress, it ends without a force.
    void cutMotors() noexcept override;
    /// Errors: argumentInvalid (already started), outOfMemory.
    Result<void> start(StylusClient& client) override;
    void stop() noexcept override;

private:
    static unsigned int called(void* self) noexcept;
    bool frame() noexcept;
    void finish() noexcept;
    void tickWithoutReading(double time) noexcept;
    StylusState read(double time) noexcept;
    void drive(const Wrench& wrench, unsigned int cutsBefore) noexcept;
    void takeErrors(double time) noexcept;
    void disconnect() noexcept;
    void reconnectWhenLost() noexcept;
    void reconnect() noexcept;
    bool stops() const noexcept { return stop_.load(std::memory_order_relaxed); }

    std::shared_ptr<HdLibrary> library_;
    const HdApi& api_;
    std::string name_;
    std::atomic<HdHandle> handle_;
    StylusDescription description_;
    Result<void> calibrated_;
    FaultBox faults_;
    std::atomic<std::uint64_t> readings_{0};
    std::atomic<double> heat_{0.0};
    std::atomic<bool> lost_{false}, stop_{false}, ended_{false};
    std::atomic<unsigned int> cuts_{0};

    StylusClient* client_ = nullptr; // this member and the following belong to the scheduler's thread while it calls
    bool begun_ = false;
    bool forcesOff_ = true; ///< forces have to be switched on by the next answer
    double startedAt_ = 0.0, calmFrom_ = 0.0;
    int frames_ = 0;

    HdScheduled scheduled_ = 0;
    std::thread reconnecting_;
    bool uncalibratedTold_ = false; ///< belongs to the reconnecting thread
};

/// Calibrates the current device if that is possible without the user's hand. Errors: deviceFault (the hand is needed).
/// @param name for messages
Result<void> calibrateCurrent(const HdApi& api, const std::string& name);

} // namespace burin::openhaptics
