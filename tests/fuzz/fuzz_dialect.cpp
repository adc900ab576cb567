// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/nc/data_post.h"
#include "core/nc/dialect_data.h"
#include "core/nc/post.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

using namespace burin;

namespace {

/// A block up, over, down, along and around: each word that a dialect may have is asked for.
NcProgram smallProgram(const MachineProfile& machine) {
    Path path;
    path.toolId = "ball-6";
    path.points = {{{0.0, 0.0, 5.0}}, {{0.0, 0.0, 0.0}}, {{10.0, 0.0, 0.0}}};
    PostRequest request;
    request.programName = "fuzz";
    request.header = {"a comment", "\xc3\xa4 (in brackets)"};
    request.tools = {{"ball-6", {1, "ball 6 mm", SpindleDirection::clockwise}}};
    request.safeHeight = 10.0;
    auto program = toProgram({path}, request, machine);
    return program ? std::move(*program) : NcProgram{};
}

} // namespace

/// Whatever a dialect says, writing a program in it ends, with a text or one error.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    const std::string_view text(reinterpret_cast<const char*>(bytes), count);
    auto dialect = dialectFromJson(text, "fuzz");
    if (!dialect) return 0;
    static const MachineProfile machine;
    static const NcProgram program = smallProgram(machine);
    Progress progress;
    static_cast<void>(writeProgram(program, machine, DataPost(std::move(*dialect)), progress));
    return 0;
}
