// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/program_job.h"

namespace burin {

/// A program that continues where another one was interrupted.
struct RestartedProgram {
    CheckedProgram program;
    std::uint32_t from = 0; ///< requested line of the interrupted program
    std::uint32_t line = 0; ///< line in the interrupted program of the first cut that is made
    double lead = 0.0;      ///< mm of the path before that line that are repeated
    glm::dvec3 place{0.0};  ///< mm, program coordinates: where the tool returns to the path
};

/// Makes the remainder of an interrupted program, from a line of its text on, with a safe re-entry into the cut, and
/// checks it on the workpiece left by the lines before. If the tool can't plunge onto the path near that line, the
/// program restarts where the interrupted program last plunged.
/// @param text of the interrupted program, in the dialect of the request. @param line from 1
/// @param request name, dialect, units, tolerance and tools of the new program
/// Errors: those of parseProgram, restartAt, writeProgram and checkProgram; argumentInvalid (a line that is not there).
Result<RestartedProgram> makeRestart(const MillingContext& milling, const std::string& text, std::uint32_t line,
                                     const ProgramRequest& request, Progress& progress);

} // namespace burin
