// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <libevdev/libevdev.h>

#include <memory>
#include <vector>

namespace burin::test {

struct VirtualAxis {
    unsigned int code;
    int low, high, flat = 0, resolution = 0;
};

/// An input device as described by libevdev, without a device in the kernel.
inline std::unique_ptr<libevdev, decltype(&libevdev_free)> virtualInput(const std::vector<VirtualAxis>& axes,
                                                                        const std::vector<unsigned int>& keys) {
    std::unique_ptr<libevdev, decltype(&libevdev_free)> device(libevdev_new(), &libevdev_free);
    for (const VirtualAxis& axis : axes) {
        input_absinfo info{};
        info.minimum = axis.low;
        info.maximum = axis.high;
        info.flat = axis.flat;
        info.resolution = axis.resolution;
        libevdev_enable_event_code(device.get(), EV_ABS, axis.code, &info);
    }
    for (const unsigned int key : keys) libevdev_enable_event_code(device.get(), EV_KEY, key, nullptr);
    return device;
}

inline input_event eventOf(unsigned int type, unsigned int code, int value) {
    input_event event{};
    event.type = static_cast<std::uint16_t>(type);
    event.code = static_cast<std::uint16_t>(code);
    event.value = value;
    return event;
}

} // namespace burin::test
