// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/nc/parsed_program.h"

#include <string>
#include <string_view>

namespace burin {

/// Reads the RS274 words that Burin's LinuxCNC post-processor writes, and their close kin: G0 G1 G2 G3 (arcs by I J K,
/// incremental, planes G17 G18 G19) G4 G17–G21 G40 G43 G49 G54–G59 G61 G64 G80 G90
/// G91 G91.1 G94, M0 M1 M2 M3 M4 M5 M6 M7 M8 M9 M30, F S T H P Q N, comments, block delete, %. Anything else is an
/// error with line and column, never ignored. Lengths are millimetres until G20. Blocks behind / are carried out (block
/// delete off). Feeds must be given; incremental moves and arcs from an unknown place are errors. What stands behind a
/// closing % is not read. Cost: linear; more than a million lines a second. Errors: programSyntax.
/// @param origin file name for messages
Result<ParsedProgram> parseProgram(std::string_view text, const std::string& origin);

} // namespace burin
