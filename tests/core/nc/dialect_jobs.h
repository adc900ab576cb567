// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/nc/dialect_library.h"
#include "core/nc/post.h"

#include <string>

namespace burin {

/// A machine with enough travel for every job here and no special requirements.
inline MachineProfile roomyMachine() {
    MachineProfile machine;
    machine.travel = {1000, 1000, 1000};
    machine.maximumFeed = 10000;
    machine.maximumSpindleSpeed = 30000;
    machine.toolChangeHeight = 60;
    machine.coordinateDecimals = 3;
    machine.maximumLineLength = 255;
    return machine;
}

inline NcMove rapidTo(double x, double y, double z) {
    return {NcMoveKind::rapid, {x, y, z}, 0.0, 0, -1, ""};
}
inline NcMove lineTo(double x, double y, double z, double feed, std::string comment = {}) {
    return {NcMoveKind::line, {x, y, z}, feed, 1, 1, std::move(comment)};
}
inline NcMove arcTo(const glm::dvec3& to, const glm::dvec3& centre, int axis, bool clockwise, double feed) {
    NcMove move{NcMoveKind::arc, AxisValues(to), feed, 1, 1, ""};
    move.arc = {centre, axis, clockwise};
    return move;
}
inline NcMove dwellFor(double seconds) {
    NcMove move{NcMoveKind::dwell, {}, 0.0, 0, -1, ""};
    move.seconds = seconds;
    return move;
}

/// Two tools (one where `tools` is 1), lines, arcs in all planes, a full circle, a helix and a dwell.
inline NcProgram referenceJob(NcUnits units, int tools = 2) {
    NcProgram program;
    program.name = "Reference job";
    program.header = {"Part: plate (aluminium), 20 mm", "MSG, not an order"};
    program.units = units;
    program.safeHeight = 10;
    program.blendTolerance = 0.01;
    NcSection& first = program.sections.emplace_back();
    first.toolNumber = 3;
    first.toolName = "Ball-end mill 6 mm";
    first.spindleSpeed = 12000;
    first.coolant = Coolant::flood;
    first.moves = {rapidTo(-5.0004, 12.3456, 10),
                   rapidTo(-5.0004, 12.3456, 1),
                   lineTo(-5.0004, 12.3456, -0.0004, 300, "take 1, sample 17"), // rounds to 0.000, not -0.000
                   lineTo(-4.0004, 12.3459, 0.0003, 1234.56),
                   lineTo(0, 10, -1, 1234.56),
                   arcTo({10, 0, -1}, {0, 0, 0}, 2, true, 600),     // a quarter
                   arcTo({10, 0, -1}, {0, 0, 0}, 2, false, 600),    // a full circle
                   arcTo({-10, 0, -3}, {0, 0, 0}, 2, false, 450.5), // half a turn of a helix
                   arcTo({-20, 0, -13}, {-20, 0, -3}, 1, true, 450.5),
                   arcTo({-20, 10, -3}, {-20, 0, -3}, 0, false, 450.5),
                   dwellFor(0.5),
                   rapidTo(-20, 10, 10)};
    if (tools == 1) return program;
    NcSection& second = program.sections.emplace_back();
    second.toolNumber = 12;
    second.toolName = "Flat end mill 10 mm";
    second.spindleSpeed = 8000;
    second.direction = SpindleDirection::anticlockwise;
    second.moves = {rapidTo(1, 2, 10), lineTo(1, 2, -2, 200), lineTo(30.5, 2, -2, 800), rapidTo(30.5, 2, 10)};
    return program;
}

inline Result<std::string> posted(const std::string& dialect, const NcProgram& program,
                                  const MachineProfile& machine = roomyMachine()) {
    const auto post = loadDialect(dialect);
    if (!post) return post.error();
    Progress progress;
    return writeProgram(program, machine, **post, progress);
}

} // namespace burin
