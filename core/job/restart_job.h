// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/program_job.h"

namespace burin {

/// A program that goes on where another one was interrupted.
struct RestartedProgram {
    CheckedProgram program;
    std::uint32_t from = 0; ///< line of the interrupted program that was asked for
    std::uint32_t line = 0; ///< of that program: the first cut that it makes
    double lead = 0.0;      ///< mm of the path before it that it makes again
    glm::dvec3 place{0.0};  ///< mm, program coordinates: where the tool comes back to the path
};

/// Makes the rest of an interrupted program, from a line of its text on, with a safe way back into the cut, and judges
/// it on the workpiece as the lines before that one left it. Where the tool can't come down on the path near the line,
/// it goes back to where the program itself came down last.
/// @param text of the interrupted program, in the dialect of the request. @param line from 1
/// @param request name, dialect, units, tolerance and tools of the new program
/// Errors: those of parseProgram, restartAt, writeProgram and checkProgram; argumentInvalid (a line that is not there).
Result<RestartedProgram> makeRestart(const MillingContext& milling, const std::string& text, std::uint32_t line,
                                     const ProgramRequest& request, Progress& progress);

} // namespace burin
