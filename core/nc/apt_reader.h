// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/nc/parsed_program.h"

#include <string>
#include <string_view>

namespace burin {

class Kinematics;

/// Whether a text is a cutter location file (APT/CL, CLDATA): records such as GOTO/ and FEDRAT/ rather than G-code. The
/// beginning of the text suffices.
bool isCutterLocations(std::string_view text);

/// Reads the cutter locations that a CAM system passes to a post-processor, UNITS, LOADTL,
/// LOAD/TOOL, SPINDL, FEDRAT, RAPID, FROM, GOTO, GODLTA, CIRCLE and MOVARC about Z, COOLNT, DELAY, END, FINI. Positions
/// are those of the tool tip in the frame of the work offset. Records that move nothing (PARTNO, PPRINT, CUTTER, INTOL
/// …) are skipped; a record that would move the machine in another way (CYCLE, CUTCOM, COPY) is an
/// error, never ignored. A line that ends in $ continues in the next one; $$ begins a comment. Cost: linear.
/// Tool axes (TLAXIS, GOTO with six numbers) become values of the machine's rotary axes.
/// @param origin file name for messages @param kinematics of the machine, with the program's zero at the origin; null:
/// the tool has to be upright
/// Errors: programSyntax (place: the line).
Result<ParsedProgram> parseCutterLocations(std::string_view text, const std::string& origin,
                                           const Kinematics* kinematics = nullptr);

} // namespace burin
