// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/plugins/stand_ins/dhd_stand_in.h"

#include <algorithm>
#include <cmath>

#ifndef DHD_MINOR
#define DHD_MINOR 17
#endif

using burin::testing::DhdDevice;
using burin::testing::DhdStandIn;

namespace burin::testing {

extern "C" [[gnu::visibility("default")]] DhdStandIn* burinDhdStandIn() {
    static DhdStandIn instance;
    return &instance;
}

DhdDevice* DhdStandIn::find(char id, const char* call) {
    const auto place = static_cast<std::size_t>(id);
    if (id < 0 || place >= devices.size() || !devices[place].open) {
        complain(std::string(call) + " of a device that is not open");
        return nullptr;
    }
    return &devices[place];
}

} // namespace burin::testing

#define DHD_EXPORT extern "C" [[gnu::visibility("default")]]

namespace {

DhdStandIn& dhdStandIn() {
    return *burin::testing::burinDhdStandIn();
}

/// Runs `act` on an open, plugged device; returns -1 if there is none.
template <class Act>
int with(char id, const char* call, const Act& act) {
    DhdStandIn& dhd = dhdStandIn();
    const std::lock_guard lock(dhd.mutex);
    DhdDevice* device = dhd.find(id, call);
    if (device == nullptr || !device->plugged) return -1;
    return act(*device);
}

} // namespace

DHD_EXPORT int dhdGetDeviceCount() {
    DhdStandIn& dhd = dhdStandIn();
    const std::lock_guard lock(dhd.mutex);
    return static_cast<int>(std::ranges::count(dhd.devices, true, &DhdDevice::plugged));
}

DHD_EXPORT void dhdGetSDKVersion(int* major, int* minor, int* release, int* revision) {
    *major = 3;
    *minor = DHD_MINOR;
    *release = 5;
    *revision = 0;
}

DHD_EXPORT int dhdGetSystemType(char id) {
    return with(id, "dhdGetSystemType", [](DhdDevice& device) { return device.type; });
}

DHD_EXPORT const char* dhdGetSystemName(char id) {
    DhdStandIn& dhd = dhdStandIn();
    const std::lock_guard lock(dhd.mutex);
    const DhdDevice* device = dhd.find(id, "dhdGetSystemName");
    return device != nullptr ? device->name.c_str() : nullptr;
}

DHD_EXPORT int dhdEnableForce(unsigned char on, char id) {
    return with(id, "dhdEnableForce", [on](DhdDevice& device) {
        if (on != 0 && !device.initialised) dhdStandIn().complain("forces before it was initialised");
        if (on != 0 && device.regulated) dhdStandIn().complain("forces under the library's own control");
        if (on != 0) ++device.forcesSwitchedOn;
        device.forcesOn = on != 0;
        device.cause = on != 0 ? 0 : 4;
        return 0;
    });
}

DHD_EXPORT int dhdGetStatus(int* status, char id) {
    return with(id, "dhdGetStatus", [status](DhdDevice& device) {
        std::fill_n(status, 17, 0);
        status[0] = 1;
        status[2] = 1;
        status[5] = device.forcesOn ? 1 : 0;
        status[14] = device.cause;
        return 0;
    });
}

DHD_EXPORT int dhdGetPositionAndOrientationFrame(double* x, double* y, double* z, double (*rotation)[3], char id) {
    return with(id, "dhdGetPositionAndOrientationFrame", [&](DhdDevice& device) {
        if (device.failingReads > 0) {
            --device.failingReads;
            return -1;
        }
        *x = device.place[0];
        *y = device.place[1];
        *z = device.place[2];
        for (std::size_t row = 0; row < 3; ++row)
            for (std::size_t column = 0; column < 3; ++column) rotation[row][column] = device.rotation[row][column];
        return 1; // paced by the library's time guard
    });
}

DHD_EXPORT int dhdSetForceAndTorqueAndGripperForce(double fx, double fy, double fz, double tx, double ty, double tz,
                                                   double /*grip*/, char id) {
    return with(id, "dhdSetForceAndTorqueAndGripperForce", [&](DhdDevice& device) {
        if (device.deaf) return -1;
        device.asked = {fx, fy, fz, tx, ty, tz};
        for (const double part : device.asked)
            if (!std::isfinite(part)) dhdStandIn().complain("a force that is no number");
        return std::hypot(fx, fy, fz) > device.maximumForce ? 2 : 0;
    });
}

DHD_EXPORT int dhdSetMaxForce(double force, char id) {
    return with(id, "dhdSetMaxForce", [force](DhdDevice& device) {
        device.maximumForce = force;
        return 0;
    });
}

DHD_EXPORT int dhdSetGravityCompensation(int on, char id) {
    return with(id, "dhdSetGravityCompensation", [on](DhdDevice& device) { return (device.gravity = on) * 0; });
}

DHD_EXPORT int dhdSetWatchdog(unsigned char duration, char id) {
    return with(id, "dhdSetWatchdog", [duration](DhdDevice& device) { return (device.watchdog = duration) * 0; });
}

DHD_EXPORT int dhdSetBrakes(int on, char id) {
    return with(id, "dhdSetBrakes", [on](DhdDevice& device) { return (device.brakes = on) * 0; });
}

DHD_EXPORT int dhdEmulateButton(unsigned char on, char id) {
    return with(id, "dhdEmulateButton", [on](DhdDevice& device) {
        device.emulatesButton = on != 0;
        return 0;
    });
}

DHD_EXPORT unsigned int dhdGetButtonMask(char id) {
    unsigned int buttons = 0;
    (void)with(id, "dhdGetButtonMask", [&](DhdDevice& device) {
        buttons = device.buttons;
        return 0;
    });
    return buttons;
}

DHD_EXPORT bool dhdHasWrist(char id) {
    return with(id, "dhdHasWrist", [](DhdDevice& device) { return device.wrist ? 1 : 0; }) == 1;
}

DHD_EXPORT bool dhdHasActiveWrist(char id) {
    return with(id, "dhdHasActiveWrist", [](DhdDevice& device) { return device.activeWrist ? 1 : 0; }) == 1;
}

DHD_EXPORT bool dhdHasGripper(char id) {
    return with(id, "dhdHasGripper", [](DhdDevice& device) { return device.gripper ? 1 : 0; }) == 1;
}

DHD_EXPORT int drdOpenID(char id) {
    DhdStandIn& dhd = dhdStandIn();
    const std::lock_guard lock(dhd.mutex);
    const auto place = static_cast<std::size_t>(id);
    if (id < 0 || place >= dhd.devices.size() || !dhd.devices[place].plugged || dhd.devices[place].open) return -1;
    dhd.devices[place].open = true;
    return id;
}

DHD_EXPORT int drdClose(char id) {
    DhdStandIn& dhd = dhdStandIn();
    const std::lock_guard lock(dhd.mutex);
    DhdDevice* device = dhd.find(id, "drdClose");
    if (device == nullptr) return -1;
    device->open = device->forcesOn = false;
    return 0;
}

DHD_EXPORT bool drdIsInitialized(char id) {
    return with(id, "drdIsInitialized", [](DhdDevice& device) { return device.initialised ? 1 : 0; }) == 1;
}

DHD_EXPORT int drdAutoInit(char id) {
    return with(id, "drdAutoInit", [](DhdDevice& device) {
        ++device.autoInitialisations;
        device.regulated = true;
        device.initialised = device.canInitialise;
        return device.canInitialise ? 0 : -1;
    });
}

DHD_EXPORT int drdStop(bool /*keepForce*/, char id) {
    return with(id, "drdStop", [](DhdDevice& device) {
        device.regulated = false;
        return 0;
    });
}
