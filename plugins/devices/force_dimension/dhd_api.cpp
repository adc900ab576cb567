// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/force_dimension/dhd_api.h"

#include "plugins/devices/vendor/vendor_library.h"

#include <utility>

namespace burin::forcedimension {
namespace {

constexpr std::pair oldestVersion{3, 16}; // since this version angles and frames are as described

vendor::LibrarySearch search() {
    vendor::LibrarySearch search{"Force Dimension", "the Force Dimension SDK 3.16 or later", "libdrd.so", {}};
    if (const auto sdk = vendor::folderFrom("FDSDK"); !sdk.empty())
        search.folders = {sdk, sdk / "lib" / "release" / "lin-x86_64-gcc"};
    if (const auto home = vendor::folderFrom("HOME"); !home.empty()) search.folders.push_back(home / ".local" / "lib");
    return search;
}

} // namespace

Result<DhdApi> loadDhdApi() {
    const Result<vendor::VendorLibrary> library = vendor::VendorLibrary::open(search());
    if (!library) return library.error();
    DhdApi api;
    Result<void> bound;
    const auto bind = [&](auto*& function, const char* name) {
        if (bound) bound = library->bind(function, name);
    };
    bind(api.getSdkVersion, "dhdGetSDKVersion");
    if (!bound) return bound.error();
    int major = 0, minor = 0, release = 0, revision = 0;
    api.getSdkVersion(&major, &minor, &release, &revision);
    api.version = std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(release);
    if (std::pair(major, minor) < oldestVersion) return library->unfit(api.version);
    bind(api.getDeviceCount, "dhdGetDeviceCount");
    bind(api.getSystemType, "dhdGetSystemType");
    bind(api.getSystemName, "dhdGetSystemName");
    bind(api.enableForce, "dhdEnableForce");
    bind(api.getStatus, "dhdGetStatus");
    bind(api.getPose, "dhdGetPositionAndOrientationFrame");
    bind(api.setForce, "dhdSetForceAndTorqueAndGripperForce");
    bind(api.setMaximumForce, "dhdSetMaxForce");
    bind(api.setGravityCompensation, "dhdSetGravityCompensation");
    bind(api.setWatchdog, "dhdSetWatchdog");
    bind(api.setBrakes, "dhdSetBrakes");
    bind(api.getButtons, "dhdGetButtonMask");
    bind(api.hasWrist, "dhdHasWrist");
    bind(api.hasActiveWrist, "dhdHasActiveWrist");
    bind(api.hasGripper, "dhdHasGripper");
    library->bindIfThere(api.emulateButton, "dhdEmulateButton");
    bind(api.open, "drdOpenID");
    bind(api.close, "drdClose");
    bind(api.isInitialised, "drdIsInitialized");
    bind(api.autoInitialise, "drdAutoInit");
    bind(api.stopRegulation, "drdStop");
    if (!bound) return bound.error();
    return api;
}

} // namespace burin::forcedimension
