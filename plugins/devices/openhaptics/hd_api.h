// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"

namespace burin::openhaptics {

// Declared according to the published reference of OpenHaptics 3.4 (HDAPI), whose headers are not needed and not
// copied. On 64-bit Linux these are plain C functions.

using HdHandle = unsigned int;
inline constexpr HdHandle hdInvalidHandle = 0xffffffffU;

/// The result of hdGetError, returned by value.
struct HdError {
    unsigned int code = 0;
    int internal = 0;
    HdHandle device = 0;
};

/// The numbers of parameters, capabilities and results.
enum HdNumber : unsigned int {
    hdCurrentButtons = 0x2000,    ///< int: one bit per button
    hdCurrentTransform = 0x2052,  ///< 16 doubles in column order; mm
    hdDeviceModel = 0x2501,       ///< text
    hdUsableWorkspace = 0x2551,   ///< 6 doubles: minimum x y z, maximum x y z; mm
    hdInputFreedoms = 0x2553,     ///< int
    hdOutputFreedoms = 0x2554,    ///< int
    hdCalibrationStyles = 0x2555, ///< int: bits of HdStyle
    hdUpdateRate = 0x2600,        ///< int: Hz
    hdNominalStiffness = 0x2602,  ///< double: N/mm
    hdNominalForce = 0x2603,      ///< double: N
    hdContinuousForce = 0x2604,   ///< double: N
    hdMotorTemperatures = 0x2605, ///< doubles, one per motor: 0 … 1
    hdNominalDamping = 0x2609,    ///< double: N/(mm/s)
    hdCurrentForce = 0x2700,      ///< 3 doubles: N
    hdCurrentTorque = 0x2701,     ///< 3 doubles: mN·m
    hdForceOutput = 0x4000,
    hdMaximumForceClamping = 0x4001,
    hdForceRamping = 0x4002,
    hdCalibrated = 0x5000,
    hdCalibrationNeedsUpdate = 0x5001,
    hdCalibrationNeedsHand = 0x5002
};
enum HdStyle : unsigned int { hdEncoderReset = 1, hdAuto = 2, hdInkwell = 4 };
enum HdCallbackAnswer : unsigned int { hdDone = 0, hdContinue = 1 };
inline constexpr unsigned short hdHighestPriority = 0xffff;

using HdCallback = unsigned int (*)(void*);
using HdScheduled = unsigned long;

/// The functions of libHD that Burin calls.
struct HdApi {
    HdHandle (*initDevice)(const char*) = nullptr;
    void (*disableDevice)(HdHandle) = nullptr;
    void (*makeCurrentDevice)(HdHandle) = nullptr;
    void (*beginFrame)(HdHandle) = nullptr;
    void (*endFrame)(HdHandle) = nullptr;
    HdError (*getError)() = nullptr;
    void (*enable)(unsigned int) = nullptr;
    void (*disable)(unsigned int) = nullptr;
    void (*getDoublev)(unsigned int, double*) = nullptr;
    void (*getIntegerv)(unsigned int, int*) = nullptr;
    void (*setDoublev)(unsigned int, const double*) = nullptr;
    const char* (*getString)(unsigned int) = nullptr;
    unsigned int (*checkCalibration)() = nullptr;
    void (*updateCalibration)(unsigned int) = nullptr;
    HdScheduled (*scheduleAsynchronous)(HdCallback, void*, unsigned short) = nullptr;
    void (*unschedule)(HdScheduled) = nullptr;
    void (*startScheduler)() = nullptr;
    void (*stopScheduler)() = nullptr;
    void (*setSchedulerRate)(unsigned long) = nullptr;
};

/// Opens libHD, from $OH_SDK_BASE, below /opt/OpenHaptics, or where the system searches. Errors: those of
/// VendorLibrary.
Result<HdApi> loadHdApi();

} // namespace burin::openhaptics
