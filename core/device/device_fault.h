// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/error.h"
#include "core/base/text.h"

#include <array>
#include <atomic>
#include <bit>
#include <cstdint>
#include <optional>
#include <string>

namespace burin {

/// What may befall a device in the middle of its work.
enum class DeviceFault : std::uint8_t {
    unplugged,     ///< gone from the bus
    silent,        ///< there, but without a reading for longer than its rate allows
    damaged,       ///< its readings fail their check
    deaf,          ///< does not take what is sent to it
    watchdog,      ///< it heard nothing for too long and cut its motors
    notCalibrated, ///< its pose means nothing yet
    overheated,
    overloaded, ///< current or force beyond what it bears
    tooFast,
    stopped,  ///< its stop button
    mechanism ///< a sensor or a drive failed
};
inline constexpr std::size_t deviceFaultCount = 11;

/// Words of a reason, in the order of DeviceFault.
inline constexpr std::array<TextId, deviceFaultCount> deviceReasons{
    BURIN_TEXT("DeviceReason", "it is not plugged in"),
    BURIN_TEXT("DeviceReason", "it sends nothing"),
    BURIN_TEXT("DeviceReason", "its data is damaged"),
    BURIN_TEXT("DeviceReason", "it does not accept data"),
    BURIN_TEXT("DeviceReason", "it received nothing from the computer for too long"),
    BURIN_TEXT("DeviceReason", "it is not calibrated yet"),
    BURIN_TEXT("DeviceReason", "its motors are too hot"),
    BURIN_TEXT("DeviceReason", "its motors were overloaded"),
    BURIN_TEXT("DeviceReason", "it moved too fast"),
    BURIN_TEXT("DeviceReason", "its stop button is pressed"),
    BURIN_TEXT("DeviceReason", "a sensor or a drive failed"),
};

/// The message of a fault; ui/messages words it. Owner's thread: allocates.
inline Error errorOf(DeviceFault fault, std::string device) {
    if (fault == DeviceFault::unplugged) return {ErrorCode::deviceUnplugged, std::move(device), {}, {}};
    const bool lasting = fault == DeviceFault::mechanism;
    return {lasting ? ErrorCode::deviceFault : ErrorCode::deviceStopped,
            std::move(device),
            {},
            deviceReasons[static_cast<std::size_t>(fault)].text};
}

/// Carries faults from the thread that meets them to the owner's: each kind once until it is taken. No lock, no
/// allocation. @tparam Kind an enumeration of at most 32
template <class Kind>
class BoxOf {
public:
    /// Any thread.
    void raise(Kind fault) noexcept { raised_.fetch_or(1U << static_cast<unsigned>(fault), std::memory_order_release); }
    /// Any thread: one of those raised since, in the order of Kind.
    std::optional<Kind> take() noexcept {
        std::uint32_t raised = raised_.load(std::memory_order_acquire);
        while (raised != 0)
            if (raised_.compare_exchange_weak(raised, raised & (raised - 1), std::memory_order_acq_rel))
                return static_cast<Kind>(std::countr_zero(raised));
        return std::nullopt;
    }

private:
    std::atomic<std::uint32_t> raised_{0};
};
using FaultBox = BoxOf<DeviceFault>;

} // namespace burin
