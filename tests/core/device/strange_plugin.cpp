// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/device/device_driver.h"

#include <cstdlib>

// A plugin that was built with other headers than it claims: its reading is shorter.

extern "C" [[gnu::visibility("default")]] const burin::TypeLayout* burinDeviceLayout(std::uint32_t* count) {
    static auto layout = burin::deviceLayout;
    for (burin::TypeLayout& type : layout)
        if (std::string(type.type) == "StylusState") type.size -= 8;
    *count = static_cast<std::uint32_t>(layout.size());
    return layout.data();
}

extern "C" [[gnu::visibility("default")]] burin::DeviceDriver* burinCreateDeviceDriver(burin::DeviceHost& /*host*/) {
    std::abort(); // none of its code except the layout may run
}
