// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/material_file.h"
#include "core/cutting/material_library.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

/// A card that is read can be milled, and gives the same material when read from Burin's own form.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    const std::string_view text(reinterpret_cast<const char*>(bytes), count);
    const auto read = burin::materialFromText(text, "fuzz");
    if (!read) return 0;
    if (!burin::checkMaterial(read->material, "fuzz")) std::abort();
    const std::string written = burin::toJson(read->material);
    const auto again = burin::materialFromText(written, "fuzz");
    if (!again || burin::toJson(again->material) != written) std::abort();
    return 0;
}
