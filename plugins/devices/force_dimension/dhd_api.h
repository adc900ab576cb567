// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"

#include <array>
#include <string>

namespace burin::forcedimension {

// Declared according to the published reference of the Force Dimension SDK 3.16 (DHD, DRD), whose headers are not
// needed and not copied. Functions return a negative number if they fail; 1 (paced by the library) and 2 (a motor at
// its limit) are not failures.

using DhdId = char;
inline constexpr int dhdStatusLength = 17;
/// Indices of the values of dhdGetStatus.
enum DhdStatus : std::size_t { dhdPowered = 0, dhdForces = 5, dhdFailed = 9, dhdForceOffCause = 14 };
inline constexpr unsigned char dhdWatchdogTick = 125; ///< µs

/// The functions of libdrd that Burin calls; libdrd also contains those of libdhd.
struct DhdApi {
    int (*getDeviceCount)() = nullptr;
    int (*getSystemType)(DhdId) = nullptr;
    const char* (*getSystemName)(DhdId) = nullptr;
    void (*getSdkVersion)(int*, int*, int*, int*) = nullptr;
    int (*enableForce)(unsigned char, DhdId) = nullptr;
    int (*getStatus)(int*, DhdId) = nullptr;
    int (*getPose)(double*, double*, double*, double (*)[3], DhdId) = nullptr; ///< m; rows of a rotation matrix
    int (*setForce)(double, double, double, double, double, double, double, DhdId) = nullptr; ///< N, N·m, N
    int (*setMaximumForce)(double, DhdId) = nullptr;                                          ///< N
    int (*setGravityCompensation)(int, DhdId) = nullptr;
    int (*setWatchdog)(unsigned char, DhdId) = nullptr;
    int (*setBrakes)(int, DhdId) = nullptr;
    unsigned int (*getButtons)(DhdId) = nullptr;
    bool (*hasWrist)(DhdId) = nullptr;
    bool (*hasActiveWrist)(DhdId) = nullptr;
    bool (*hasGripper)(DhdId) = nullptr;
    int (*emulateButton)(unsigned char, DhdId) = nullptr; ///< for the gripper; null in old versions
    int (*open)(DhdId) = nullptr;                         ///< drdOpenID
    int (*close)(DhdId) = nullptr;
    bool (*isInitialised)(DhdId) = nullptr;
    int (*autoInitialise)(DhdId) = nullptr;
    int (*stopRegulation)(bool, DhdId) = nullptr;
    std::string version; ///< "3.17.5"
};

/// Opens libdrd, from $FDSDK or where the system searches. Errors: those of VendorLibrary, deviceLibraryUnfit for a
/// version before 3.16.
Result<DhdApi> loadDhdApi();

} // namespace burin::forcedimension
