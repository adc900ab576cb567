// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/spacenav/events.h"

#include <cstdlib>

/// Whatever a daemon sends: no fault, and no axis beyond twice the full deflection of a cap.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    burin::spacenav::EventReader reader;
    std::span<const std::uint8_t> bytes(data, size);
    while (!bytes.empty()) {
        (void)reader.take(bytes);
        for (const std::int16_t axis : reader.controls().axes)
            if (axis > 700 || axis < -700) std::abort();
    }
    return 0;
}
