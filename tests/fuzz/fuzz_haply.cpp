// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/haply/state_scanner.h"

#include <cstddef>

/// Whatever a service sends causes no fault.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    (void)burin::haply::scanState({reinterpret_cast<const char*>(data), size}, "04BA");
    return 0;
}
