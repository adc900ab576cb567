// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/device_fault.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace burin {

/// Why a loop rendered no force, and lets it fade in again.
enum class TickFault : std::uint8_t {
    none,
    device,  ///< the stylus had no valid reading; it reports the reason itself
    damaged, ///< a reading that is not finite, or an implausible position
    tooFast, ///< faster than is plausible for the stylus, or a jump
    stalled, ///< the loop was late by more than GapLimits::stalled
    dead,    ///< no tick for GapLimits::dead: the watchdog cut the motors
};

/// The text of each fault, in the order of TickFault; empty if nothing is to be reported.
inline constexpr std::array<TextId, 6> tickFaultReasons{
    TextId{""},
    TextId{""},
    deviceReasons[static_cast<std::size_t>(DeviceFault::damaged)],
    deviceReasons[static_cast<std::size_t>(DeviceFault::tooFast)],
    BURIN_TEXT("DeviceReason", "the computer was late with its force"),
    BURIN_TEXT("DeviceReason", "the computer did not respond, so its motors were switched off"),
};

/// The name as used in file names.
constexpr std::string_view nameOf(TickFault fault) noexcept {
    constexpr std::array<std::string_view, 6> names{"none", "device", "damaged", "too-fast", "stalled", "dead"};
    return names[static_cast<std::size_t>(fault)];
}

/// Limits of the time that the hand may wait for its next force, s.
struct GapLimits {
    double late;    ///< beyond it: no force in that tick, and the tick counts as late
    double stalled; ///< beyond it: forces fade in again
    double dead;    ///< beyond it: a second thread cuts the motors
};

/// Usual values in haptics at 1 kHz: 3, 10 and 50 ms; for slower devices at least 3, 10 and 10 of their periods.
/// @param period s
constexpr GapLimits gapLimits(double period) noexcept {
    const auto atLeast = [](double seconds, double other) { return seconds > other ? seconds : other; };
    return {atLeast(0.003, 3.0 * period), atLeast(0.010, 10.0 * period), atLeast(0.050, 10.0 * period)};
}

} // namespace burin
