// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/tool/tool_exchange.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

namespace {

burin::Tool lender() {
    burin::Tool tool;
    tool.id = "lender";
    tool.name = "Lender";
    tool.source = "fuzz";
    tool.cutter = {burin::CutterType::flat, 6.0, 0.0, 13.0, 6.0, 30.0, {{28.0, 28.0, 18.0}}};
    tool.maximumDepthOfCut = 9.0;
    return tool;
}

void judge(const burin::Tool& tool) {
    for (const burin::RevolvedPiece& piece : burin::pieces(tool.cutter))
        if (!(piece.bottom < piece.top && piece.bottomRadius >= 0.0 && piece.topRadius >= 0.0) ||
            !std::isfinite(piece.top + piece.widestRadius()))
            std::abort();
    const std::string written = burin::toJson(tool);
    const auto again = burin::toolFromJson(written, "fuzz");
    if (!again || burin::toJson(*again) != written) std::abort();
}

} // namespace

/// A tool that was read, from Burin's own form or a library of another program, has a valid outline, is written and
/// read again: both texts must be the same.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    const std::string_view text(reinterpret_cast<const char*>(bytes), count);
    const auto read = burin::toolsFromText(text, "fuzz", lender(), 1.0);
    if (!read) return 0;
    for (const burin::ReadTool& each : read->tools) judge(each.tool);
    return 0;
}
