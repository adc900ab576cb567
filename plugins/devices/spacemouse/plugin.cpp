// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/spacemouse/driver.h"

extern "C" [[gnu::visibility("default")]] burin::DeviceDriver* burinCreateDeviceDriver(burin::DeviceHost& host) {
    return burin::spacemouse::makeDriver(burin::hid::systemBus(host)).release();
}
