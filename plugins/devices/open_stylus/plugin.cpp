// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/open_stylus/driver.h"

extern "C" [[gnu::visibility("default")]] burin::DeviceDriver* burinCreateDeviceDriver(burin::DeviceHost& host) {
    return burin::openstylus::makeDriver(burin::hid::systemBus(host)).release();
}
