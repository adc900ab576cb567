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

MachineProfile machine() {
    MachineProfile made;
    made.travel = glm::dvec3(500.0);
    made.maximumFeed = 2000.0;
    made.rapidFeed = 5000.0;
    made.maximumSpindleSpeed = 24000.0;
    made.maximumLineLength = 100'000;
    return made;
}

/// A path up, over, down, along, around by arc and helix in each plane, and up again.
Path pathOf(const char* tool, Coolant coolant) {
    Path path;
    path.toolId = tool;
    path.spindleSpeed = 10000.5;
    path.coolant = coolant;
    path.points = {{{{0.0, 0.0, 5.0}}, MoveKind::rapid},
                   {{{0.0, 0.0, 0.0}}, MoveKind::plunge, 300.0},
                   {{{10.0, 0.0, 0.0}}, MoveKind::cut, 900.125, 7, 123},
                   {{{10.0, 4.0, -1.0}}, MoveKind::cut, 900.0, 7, 124, PathArc{{10.0, 2.0, 0.0}, 2, false}},
                   {{{14.0, 4.0, -1.0}}, MoveKind::cut, 900.0, 7, 125, PathArc{{12.0, 4.0, -1.0}, 1, true}},
                   {{{14.0, 8.0, -1.0}}, MoveKind::cut, 900.0, 7, 126, PathArc{{14.0, 6.0, -1.0}, 0, false}},
                   {{{14.0, 8.0, -1.0}}, MoveKind::cut, 900.0, 7, 127, PathArc{{14.0, 6.0, -1.0}, 2, true}},
                   {{{14.0, 8.0, 4.0}}, MoveKind::retract, 900.0},
                   {{{14.0, 8.0, 5.0}}, MoveKind::rapid}};
    return path;
}

NcProgram programOf(NcUnits units, const std::vector<Path>& paths, const MachineProfile& machine) {
    PostRequest request;
    request.programName = "fuzz";
    request.header = {"a comment", "\xc3\xa4 (in brackets)"};
    request.units = units;
    request.tools = {{"ball-6", {1, "ball 6 mm", SpindleDirection::clockwise}},
                     {"flat-6", {12, "flat (6 mm)", SpindleDirection::anticlockwise}}};
    request.safeHeight = 10.0;
    auto program = toProgram(paths, request, machine);
    if (!program) std::abort();
    return std::move(*program);
}

} // namespace

/// With any dialect, writing a program ends with a text or one error.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    const std::string_view text(reinterpret_cast<const char*>(bytes), count);
    auto dialect = dialectFromJson(text, "fuzz");
    if (!dialect) return 0;
    static const MachineProfile made = machine();
    // The first program uses every word that a dialect can have; the second one is for dialects without tool changes
    // and coolant.
    static const NcProgram whole =
        programOf(NcUnits::millimetre, {pathOf("ball-6", Coolant::flood), pathOf("flat-6", Coolant::mist)}, made);
    static const NcProgram plain = programOf(NcUnits::inch, {pathOf("ball-6", Coolant::off)}, made);
    const DataPost post(std::move(*dialect));
    for (const NcProgram* program : {&whole, &plain}) {
        Progress progress;
        const auto written = writeProgram(*program, made, post, progress);
        if (!written && written.error().code == ErrorCode::internalFault) std::abort();
    }
    return 0;
}
