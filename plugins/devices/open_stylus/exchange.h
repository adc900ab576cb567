// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/device_fault.h"
#include "plugins/devices/open_stylus/reports.h"

#include <array>
#include <atomic>
#include <cstdint>

namespace burin::openstylus {

/// What the host makes of a device's reports and answers to them: numbering, time, arming, faults, limits. No transport
/// and no clock: times are arguments, s of a clock that only rises.
///
/// Readings are valid only while the device knows its pose, reports no fault and, if it has motors, has them on as it
/// was asked to.
/// Motors are asked for only after the device has seen them switched off and reports no fault; so they never come on
/// by themselves after one.
///
/// Thread: the device's; `health`, `cut`, `emergency` any. No allocation, lock or exception but in the constructor.
class Exchange {
public:
    enum class Outcome : std::uint8_t {
        reading, ///< a new one
        old,     ///< one that was seen already, or that a newer one has overtaken
        damaged,
    };
    static constexpr int armingReports = 3;    ///< answers with the motors off before they are asked for
    static constexpr int damagedInARow = 10;   ///< until that is a fault
    static constexpr int backwardsInARow = 8;  ///< until the device counts as started anew
    static constexpr double deafSeconds = 0.1; ///< without an echo although the device goes on sending

    explicit Exchange(const Identity& identity) noexcept;

    /// A new session: time begins with 0.
    void begin() noexcept {
        state_ = {};
        restart();
    }
    /// After connecting: forgets numbers, time of the device and arming. The session's time goes on.
    void restart() noexcept;
    /// @param now s
    Outcome take(Bytes report, double now) noexcept;
    /// One more reading had arrived before this one was answered.
    void overtaken() noexcept { overtaken_.fetch_add(1, std::memory_order_relaxed); }
    /// The newest reading, its rotation of unit length.
    const StylusState& state() const noexcept { return state_; }
    /// What to tell the client while nothing comes. @param elapsed s since the last thing it was told
    const StylusState& silence(double elapsed) noexcept;
    /// The answer to the newest reading. Shortened to the device's limits (less one step of the report, 2^-16) with its
    /// direction kept; what is not finite, or meant for motors that are not on, is sent as zero.
    std::array<std::uint8_t, outputSize> answer(const Wrench& wrench, double now) noexcept;
    /// Motors off, whatever went before.
    std::array<std::uint8_t, outputSize> farewell(double now) noexcept;
    /// Any thread: what is being answered right now no longer counts, and the motors are armed anew.
    void cut() noexcept { cut_.store(true, std::memory_order_release); }
    /// Any thread: motors off, with a number that no other report has near it. @param attempt 0 …, one report each
    std::array<std::uint8_t, outputSize> emergency(int attempt) const noexcept;

    FaultBox& faults() noexcept { return faults_; }
    /// Any thread; `connected` is not told here.
    DeviceHealth health() const noexcept;

private:
    bool number(const Reading& reading) noexcept;
    void advanceTime(const Reading& reading, double now) noexcept;
    void hearEcho(const Reading& reading, double now) noexcept;
    void tellFaults(const Reading& reading) noexcept;
    std::array<std::uint8_t, outputSize> send(const Wrench& wrench, bool motors, double now) noexcept;

    Identity identity_;
    StylusState state_;
    bool known_ = false; ///< a reading has come since the restart
    std::uint16_t sequence_ = 0, echo_ = 0, faultsBefore_ = 0;
    std::atomic<std::uint16_t> sent_{0}; ///< read by any thread
    std::atomic<bool> cut_{false};
    std::uint32_t microseconds_ = 0;
    double lastTaken_ = 0.0; ///< s, of the clock of `now`
    double lastEcho_ = 0.0;  ///< s
    bool deafTold_ = false;
    bool clockHeld_ = false; ///< the device's clock told the last step of time
    int arming_ = armingReports;
    int damagedRun_ = 0, backwardsRun_ = 0;
    bool motorsOn_ = false;
    std::array<double, 256> sentAt_{}; ///< s, by the low byte of the number
    FaultBox faults_;
    std::atomic<std::uint64_t> readings_{0}, lost_{0}, damaged_{0}, repeated_{0}, overtaken_{0};
    std::atomic<double> roundTrip_{0.0}, motorHeat_{-1.0};
};

} // namespace burin::openstylus
