// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/tool/tool.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

/// A tool that was read has a sound outline, is written and read again: the same text both times.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    const std::string_view text(reinterpret_cast<const char*>(bytes), count);
    const auto tool = burin::toolFromJson(text, "fuzz");
    if (!tool) return 0;
    for (const burin::RevolvedPiece& piece : burin::pieces(tool->cutter))
        if (!(piece.bottom < piece.top && piece.bottomRadius >= 0.0 && piece.topRadius >= 0.0) ||
            !std::isfinite(piece.top + piece.widestRadius()))
            std::abort();
    const std::string written = burin::toJson(*tool);
    const auto again = burin::toolFromJson(written, "fuzz");
    if (!again || burin::toJson(*again) != written) std::abort();
    return 0;
}
