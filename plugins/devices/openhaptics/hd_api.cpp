// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/openhaptics/hd_api.h"

#include "plugins/devices/vendor/vendor_library.h"

namespace burin::openhaptics {
namespace {

vendor::LibrarySearch search() {
    vendor::LibrarySearch search{
        "3D Systems", "OpenHaptics 3.4 and the Touch Device Driver of 3D Systems", "libHD.so", {}};
    if (const auto base = vendor::folderFrom("OH_SDK_BASE"); !base.empty())
        search.folders = {base, base / "usr" / "lib", base / "lib"};
    search.folders.insert(search.folders.end(),
                          {"/opt/OpenHaptics/Developer/3.4-0/usr/lib", "/opt/OpenHaptics/Developer/3.4-0/lib64"});
    return search;
}

} // namespace

Result<HdApi> loadHdApi() {
    const Result<vendor::VendorLibrary> library = vendor::VendorLibrary::open(search());
    if (!library) return library.error();
    HdApi api;
    Result<void> bound;
    const auto bind = [&](auto*& function, const char* name) {
        if (bound) bound = library->bind(function, name);
    };
    bind(api.initDevice, "hdInitDevice");
    bind(api.disableDevice, "hdDisableDevice");
    bind(api.makeCurrentDevice, "hdMakeCurrentDevice");
    bind(api.beginFrame, "hdBeginFrame");
    bind(api.endFrame, "hdEndFrame");
    bind(api.getError, "hdGetError");
    bind(api.enable, "hdEnable");
    bind(api.disable, "hdDisable");
    bind(api.getDoublev, "hdGetDoublev");
    bind(api.getIntegerv, "hdGetIntegerv");
    bind(api.setDoublev, "hdSetDoublev");
    bind(api.getString, "hdGetString");
    bind(api.checkCalibration, "hdCheckCalibration");
    bind(api.updateCalibration, "hdUpdateCalibration");
    bind(api.scheduleAsynchronous, "hdScheduleAsynchronous");
    bind(api.unschedule, "hdUnschedule");
    bind(api.startScheduler, "hdStartScheduler");
    bind(api.stopScheduler, "hdStopScheduler");
    bind(api.setSchedulerRate, "hdSetSchedulerRate");
    if (!bound) return bound.error();
    return api;
}

} // namespace burin::openhaptics
