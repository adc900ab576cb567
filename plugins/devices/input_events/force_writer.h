// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/mailbox.h"
#include "core/base/result.h"
#include "core/device/device_fault.h"
#include "core/device/driver_thread.h"
#include "plugins/devices/input_events/effect_player.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace burin::input_events {

/// Writes the effects of one device in a thread of its own, as a write may block: the haptic loop only posts levels.
/// The device is opened when something is wanted from it, and closed `idleAfter` it, so that other programs can use it.
/// It is opened again after it was unplugged.
class ForceWriter {
public:
    static constexpr double cycle = 0.01;      ///< s
    static constexpr double staleAfter = 0.06; ///< s without levels from the loop: nothing is shown
    static constexpr double idleAfter = 0.5;   ///< s without anything wanted: the device is closed
    static constexpr double searchEvery = 0.5; ///< s, attempts to open it

    /// @param name, node of the device, for errors
    ForceWriter(OpenEffectPort open, const ForceAbilities& abilities, std::string name, std::string node);
    ~ForceWriter() { stop(); }
    ForceWriter(const ForceWriter&) = delete;
    ForceWriter& operator=(const ForceWriter&) = delete;

    /// Owner's thread. Errors: argumentInvalid (already running), outOfMemory.
    Result<void> start();
    /// Owner's thread. Waits for a write under way, then stops the effects and closes the device.
    void stop() noexcept { thread_.stop(); }
    /// Owner's thread. The oldest fault that was not taken: deviceStopped, deviceAssistDenied.
    std::optional<Error> takeFault();
    /// Owner's thread: the device is known not to be writable.
    void forbid() noexcept { faults_.raise(ForceFault::notAllowed); }

    /// Haptic thread: to be called before a reading. Levels that are posted later belong to this reading.
    void reads() noexcept { cutsSeen_ = cuts_.load(std::memory_order_acquire); }
    /// Haptic thread. @param now s, as of steadySeconds
    void post(const EffectLevels& levels, double now) noexcept { cues_.post({levels, now, cutsSeen_}); }
    /// Any thread: nothing is shown until levels arrive that belong to a reading made after this call.
    void cut() noexcept { cuts_.fetch_add(1, std::memory_order_release); }

    /// One cycle of the thread. Called by it, or without it by tests.
    void step(double now) noexcept;
    void close() noexcept; ///< as `step`: stops the effects and closes the device

private:
    enum class ForceFault : std::uint8_t { notAllowed, deaf };
    struct Cue {
        EffectLevels levels;
        double at = 0.0; ///< s
        std::uint32_t cuts = 0;
    };
    void run() noexcept;
    bool open(double now) noexcept;
    void fail(int fault, double now) noexcept;

    const OpenEffectPort open_;
    const ForceAbilities abilities_;
    const std::string name_, node_;
    Mailbox<Cue> cues_;
    std::atomic<std::uint32_t> cuts_{0};
    std::uint32_t cutsSeen_ = 0; ///< used by the haptic thread only
    BoxOf<ForceFault> faults_;
    DriverThread thread_;

    Cue cue_; ///< this member and the following belong to the writing thread
    std::unique_ptr<EffectPort> port_;
    std::unique_ptr<EffectPlayer> player_;
    std::optional<double> wantedAt_; ///< s
    double openAt_ = 0.0;            ///< s, next attempt
    bool failing_ = false;           ///< the fault was reported
};

} // namespace burin::input_events
