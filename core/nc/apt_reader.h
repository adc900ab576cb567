// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/nc/parsed_program.h"

#include <string>
#include <string_view>

namespace burin {

/// Whether a text is a cutter location file (APT/CL, CLDATA): records such as GOTO/ and FEDRAT/ rather than G-code. The
/// beginning of the text suffices.
bool isCutterLocations(std::string_view text);

/// Reads the cutter locations that a CAM system passes to a post-processor, for an upright tool: UNITS, LOADTL,
/// LOAD/TOOL, SPINDL, FEDRAT, RAPID, FROM, GOTO, GODLTA, CIRCLE and MOVARC about Z, COOLNT, DELAY, END, FINI. Positions
/// are those of the tool tip in the frame of the work offset. Records that move nothing (PARTNO, PPRINT, CUTTER, INTOL
/// …) are skipped; a record that would move the machine in another way (CYCLE, CUTCOM, COPY, a tilted axis) is an
/// error, never ignored. A line that ends in $ continues in the next one; $$ begins a comment. Cost: linear.
/// Errors: programSyntax (place: the line). @param origin file name for messages
Result<ParsedProgram> parseCutterLocations(std::string_view text, const std::string& origin);

} // namespace burin
