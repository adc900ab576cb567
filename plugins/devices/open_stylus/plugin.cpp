// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/open_stylus/driver.h"

namespace {

std::unique_ptr<burin::DeviceDriver> makeDriver(burin::DeviceHost& host) {
    return burin::openstylus::makeDriver(burin::hid::systemBus(host));
}

} // namespace

BURIN_DEVICE_PLUGIN(makeDriver)
