// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/nc/parsed_program.h"
#include "core/nc/post.h"

#include <map>

namespace burin {

/// Where the tool of a restarted program returns to the path.
enum class RestartEntry : std::uint8_t {
    lead,   ///< on the path, a little before the next cut, from above
    retract ///< where the program itself was last above everything; it comes down as it did then
};

/// How to continue a program that was interrupted, e.g. by a broken tool. Lengths are in mm, heights are above program
/// zero.
struct RestartRequest {
    std::uint32_t line = 0; ///< in the text of the program, from 1: everything before it is done
    RestartEntry entry = RestartEntry::lead;
    double lead = 0.0;       ///< length of the path before the next cut that is repeated
    double freeHeight = 0.0; ///< the stock is below this height: from here on the tool goes down at feed
    std::string programName;
    std::vector<std::string> header; ///< comment lines
    NcUnits units = NcUnits::millimetre;
    double safeHeight = 0.0;       ///< travel is free there
    std::map<int, PostTool> tools; ///< by number in the text; 0: for a text that calls none
};

struct Restart {
    NcProgram program;
    std::size_t done = 0;  ///< motions of the interrupted program that are not repeated, except for the lead
    std::uint32_t cut = 0; ///< line of the next cut
    double lead = 0.0;     ///< length of the path before it that is repeated, mm
    AxisValues place;      ///< program coordinates of the point where the tool returns to the path
};

/// The remainder of a program with a beginning of its own: the dialect's first blocks, tool, spindle and coolant as
/// they were, the approach at the safe height, down at feed onto the path before the line, and along it. Rapids after
/// the last cut are left to the end of the dialect. What the remainder does is unchanged; canned cycles are written as
/// moves.
/// Errors: argumentInvalid (no cut at or after the line; a position or feed there that the text does not state; a cut
/// without a running spindle), nameUnknown (a tool that the request does not name), notSupported (a zero set by the
/// program itself, a later change of the work offset or of the path mode).
Result<Restart> restartAt(const ParsedProgram& program, const RestartRequest& request);

} // namespace burin
