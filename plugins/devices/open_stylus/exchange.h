// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/device_fault.h"
#include "plugins/devices/open_stylus/reports.h"

#include <array>
#include <atomic>
#include <cstdint>

namespace burin::openstylus {

/// The host's side of the protocol: interprets a device's reports and answers them; numbering, time, arming, faults,
/// limits. Without transport and clock: times are arguments, s of a monotonic clock.
///
/// Readings are valid only while the device knows its pose, reports no fault and, if it has motors, has switched them
/// on as requested.
/// Motors are requested only after the device has received reports that switch them off and reports no fault, so that
/// they never come on by themselves after a fault.
///
/// Called on the device's thread; `health`, `cut` and `emergency` on any thread. No allocation, lock or exception
/// except in the constructor.
class Exchange {
public:
    enum class Outcome : std::uint8_t {
        reading, ///< a new reading
        old,     ///< a reading that was received before, or that was superseded by a newer one
        damaged,
    };
    static constexpr int armingReports = 3;  ///< answers with the motors off before they are requested
    static constexpr int damagedInARow = 10; ///< number of consecutive damaged reports that counts as a fault
    /// number of reports with old numbers after which the device counts as restarted
    static constexpr int backwardsInARow = 8;
    static constexpr double deafSeconds = 0.1; ///< s without an echo although the device continues to send

    explicit Exchange(const Identity& identity) noexcept;

    /// Starts a new session: time begins at 0.
    void begin() noexcept {
        state_ = {};
        restart();
    }
    /// To be called after connecting: discards numbers, time of the device and arming. The session's time goes on.
    void restart() noexcept;
    /// @param now s
    Outcome take(Bytes report, double now) noexcept;
    /// To be called when a further reading had arrived before this one was answered.
    void overtaken() noexcept { overtaken_.fetch_add(1, std::memory_order_relaxed); }
    /// The newest reading, its rotation of unit length.
    const StylusState& state() const noexcept { return state_; }
    /// The state to pass to the client while no reading arrives. @param elapsed s since the last state passed to it
    const StylusState& silence(double elapsed) noexcept;
    /// The answer to the newest reading. The wrench is limited to the device's limits (less one step of the report,
    /// 2^-16) with its direction kept; a wrench that is not finite, or for motors that are not on, is sent as zero.
    std::array<std::uint8_t, outputSize> answer(const Wrench& wrench, double now) noexcept;
    /// A report that switches the motors off, whatever was sent before.
    std::array<std::uint8_t, outputSize> farewell(double now) noexcept;
    /// Any thread. The answer in progress is dropped, and the motors are armed again.
    void cut() noexcept { cut_.store(true, std::memory_order_release); }
    /// Any thread. A report that switches the motors off, with a number that is far from all numbers in use. @param
    /// attempt 0 …, one report each
    std::array<std::uint8_t, outputSize> emergency(int attempt) const noexcept;

    FaultBox& faults() noexcept { return faults_; }
    /// Any thread; `connected` is not set here.
    DeviceHealth health() const noexcept;

private:
    bool number(const Reading& reading) noexcept;
    void advanceTime(const Reading& reading, double now) noexcept;
    void hearEcho(const Reading& reading, double now) noexcept;
    void tellFaults(const Reading& reading) noexcept;
    std::array<std::uint8_t, outputSize> send(const Wrench& wrench, bool motors, double now) noexcept;

    Identity identity_;
    StylusState state_;
    bool known_ = false; ///< whether a reading has arrived since the restart
    std::uint16_t sequence_ = 0, echo_ = 0, faultsBefore_ = 0;
    std::atomic<std::uint16_t> sent_{0}; ///< read by any thread
    std::atomic<bool> cut_{false};
    std::uint32_t microseconds_ = 0;
    double lastTaken_ = 0.0; ///< s, of the clock of `now`
    double lastEcho_ = 0.0;  ///< s
    bool deafTold_ = false;
    bool clockHeld_ = false; ///< whether the last step of time was that of the device's clock
    int arming_ = armingReports;
    int damagedRun_ = 0, backwardsRun_ = 0;
    bool motorsOn_ = false;
    std::array<double, 256> sentAt_{}; ///< s, indexed by the low byte of the report's number
    FaultBox faults_;
    std::atomic<std::uint64_t> readings_{0}, lost_{0}, damaged_{0}, repeated_{0}, overtaken_{0};
    std::atomic<double> roundTrip_{0.0}, motorHeat_{-1.0};
};

} // namespace burin::openstylus
