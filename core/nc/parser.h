// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/nc/control.h"
#include "core/nc/machine_state.h"
#include "core/nc/parsed_program.h"

#include <string>
#include <string_view>

namespace burin {

/// Reads a program as a control of the RS274 family does. README.md states the subset for each control: motions and
/// arcs in all planes, canned cycles, dwells, units, feed modes, work and length offsets, G52 and G92, homes, tool
/// changes, spindle, coolant, parameters and expressions. Anything else is an error with line and column, never
/// ignored. Lengths are in millimetres until G20. Blocks after / are executed (block delete off). Feeds must be given;
/// incremental moves and arcs from a position that neither the text nor `start` determines are errors. What follows a
/// closing % is not read. A missing end is not an error here: see `ended`. Cost: linear, more than a million lines a
/// second.
/// Errors: programSyntax (detail: what is wrong, and the words concerned).
/// @param origin file name for messages
Result<ParsedProgram> parseProgram(std::string_view text, const std::string& origin, const Control& control,
                                   const MachineState& start = {});
/// The same for LinuxCNC.
Result<ParsedProgram> parseProgram(std::string_view text, const std::string& origin);

} // namespace burin
