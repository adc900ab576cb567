// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/nc/parsed_program.h"
#include "core/nc/post.h"

#include <map>

namespace burin {

/// Where the tool of a restarted program comes back to the path.
enum class RestartEntry : std::uint8_t {
    lead,   ///< on the path, a little before the cut that is next, from above
    retract ///< where the program itself was above everything last; it comes down as it did then
};

/// How a program is to go on that was interrupted, e.g. by a broken tool. Lengths are mm, heights above program zero.
struct RestartRequest {
    std::uint32_t line = 0; ///< of the program's text, from 1: everything before it is done
    RestartEntry entry = RestartEntry::lead;
    double lead = 0.0;       ///< of the path before the cut that is made again
    double freeHeight = 0.0; ///< the stock ends below: from there on the tool goes down at feed
    std::string programName;
    std::vector<std::string> header; ///< comment lines
    NcUnits units = NcUnits::millimetre;
    double safeHeight = 0.0;       ///< travel is free there
    std::map<int, PostTool> tools; ///< by number in the text; 0: of a text that calls none
};

struct Restart {
    NcProgram program;
    std::size_t done = 0;  ///< motions of the interrupted program that are not made again, but for the lead
    std::uint32_t cut = 0; ///< line of the cut that is next
    double lead = 0.0;     ///< mm of the path before it that are made again
    AxisValues place;      ///< program coordinates: where the tool comes back to the path
};

/// The rest of a program, with a beginning of its own: the dialect's first blocks, tool, spindle and coolant as they
/// were, the approach at the safe height, down at feed onto the path before the line, and along it. Rapids behind the
/// last cut are left to the dialect's end. Without a change to what the rest does; canned cycles are written as moves.
/// Errors: argumentInvalid (no cut at or behind the line; a position or feed there that the text does not state; a tool
/// that the request does not name), notSupported (a zero of the program's own, another work offset or another way to
/// take corners later on).
Result<Restart> restartAt(const ParsedProgram& program, const RestartRequest& request);

} // namespace burin
