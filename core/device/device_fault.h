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

/// Faults of a device during operation.
enum class DeviceFault : std::uint8_t {
    unplugged,     ///< gone from the bus
    silent,        ///< connected, but no reading for longer than its rate allows
    damaged,       ///< its readings fail their integrity check
    deaf,          ///< does not accept the data sent to it
    watchdog,      ///< the device received nothing for too long and switched its motors off
    notCalibrated, ///< its pose is not meaningful yet
    overheated,
    overloaded, ///< current or force above its limit
    tooFast,
    stopped,  ///< its stop button is pressed
    mechanism ///< a sensor or a drive failed
};
inline constexpr std::size_t deviceFaultCount = 11;

/// The text of each fault, in the order of DeviceFault.
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

/// The error for a fault; ui/messages words it. Owner's thread: allocates.
inline Error errorOf(DeviceFault fault, std::string device) {
    if (fault == DeviceFault::unplugged) return {ErrorCode::deviceUnplugged, std::move(device), {}, {}};
    const bool lasting = fault == DeviceFault::mechanism;
    return {lasting ? ErrorCode::deviceFault : ErrorCode::deviceStopped,
            std::move(device),
            {},
            deviceReasons[static_cast<std::size_t>(fault)].text};
}

/// Passes faults from the threads that detect them to the owner's thread. Each kind is reported once until it is taken.
/// No lock, no allocation. @tparam Kind an enumeration of at most 32 values
template <class Kind>
class BoxOf {
public:
    /// Any thread.
    void raise(Kind fault) noexcept { raised_.fetch_or(1U << static_cast<unsigned>(fault), std::memory_order_release); }
    /// Any thread. Removes and returns the first fault, in the order of Kind, of those raised since the last call.
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
