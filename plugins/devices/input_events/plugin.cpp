// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/input_events/driver.h"

namespace {

std::unique_ptr<burin::DeviceDriver> makeDriver(burin::DeviceHost& /*host*/) {
    return burin::input_events::makeDriver();
}

} // namespace

BURIN_DEVICE_PLUGIN(makeDriver)
