// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/machine/machine_library.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

/// A machine that was read is written and read again: both texts must be the same.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    const std::string_view text(reinterpret_cast<const char*>(bytes), count);
    const auto machine = burin::machineFromJson(text, "fuzz");
    if (!machine) return 0;
    const std::string written = burin::toJson(*machine);
    const auto again = burin::machineFromJson(written, "fuzz");
    if (!again || burin::toJson(*again) != written) std::abort();
    return 0;
}
