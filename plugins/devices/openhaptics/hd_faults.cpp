// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/openhaptics/hd_faults.h"

namespace burin::openhaptics {
namespace {

// Error codes of HDAPI.
constexpr unsigned int warmMotors = 0x0200, maximumForce = 0x0201, forceImpulse = 0x0202, maximumVelocity = 0x0203,
                       forceError = 0x0204, deviceFault = 0x0300, alreadyInitiated = 0x0301, communication = 0x0302,
                       communicationSetting = 0x0303, licence = 0x0600;

} // namespace

std::optional<DeviceFault> faultOf(unsigned int code) noexcept {
    switch (code) {
    case 0:
        return std::nullopt;
    case warmMotors:
        return DeviceFault::overheated;
    case maximumForce:
    case forceImpulse:
    case forceError:
        return DeviceFault::overloaded;
    case maximumVelocity:
        return DeviceFault::tooFast;
    case communication:
    case communicationSetting:
        return DeviceFault::unplugged;
    default:
        return DeviceFault::mechanism;
    }
}

Error connectionError(unsigned int code, const std::string& name) {
    switch (code) {
    case alreadyInitiated:
        return {ErrorCode::deviceFault, name, {}, BURIN_TEXT("DeviceReason", "another program uses it").text};
    case licence:
        return {ErrorCode::deviceFault, name, {}, BURIN_TEXT("DeviceReason", "OpenHaptics has no licence").text};
    case deviceFault:
        return errorOf(DeviceFault::mechanism, name);
    default: // no answer: it is not connected, or not switched on
        return {ErrorCode::deviceNotFound, name, {}, {}};
    }
}

} // namespace burin::openhaptics
