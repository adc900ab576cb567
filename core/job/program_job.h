// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/milling_context.h"
#include "core/job/program_moments.h"
#include "core/nc/lint.h"
#include "core/nc/post.h"
#include "core/path/evaluate.h"
#include "core/path/stroke.h"
#include "core/verify/verify.h"

#include <span>
#include <string>
#include <vector>

namespace burin {

/// The strokes of a stored path's sources, in its order. Errors: those of Project::visitSamples, StrokeReader and
/// Project::generatedMoves; outOfMemory, before anything is read, where the path would need more than there is.
Result<std::vector<SourceStrokes>> strokesOf(const Project& project, const StoredPath& path);
/// A stored path, evaluated on a milling context, with its sides and what it clears.
/// @param strokes   its own; moved from, where it may be
/// @param before what is milled before it, in order: `stock` for feeds by engagement, low links and sides
/// Errors: those of evaluate, millingSides, cuttingConditions and MilledStock::lend.
Result<EvaluatedPath> evaluateStored(std::vector<SourceStrokes> strokes, const MillingContext& milling,
                                     const Tool& tool, const StoredPath& path, std::span<const MilledPath> before,
                                     Progress& progress);
/// The same with the milling context's tool and sources out of a project, as if it were the only path.
/// Errors: also those of strokesOf.
Result<EvaluatedPath> evaluateStored(const Project& project, const MillingContext& milling, const StoredPath& path,
                                     Progress& progress);

struct ProgramRequest {
    std::string name;        ///< of the program
    std::string setupName{}; ///< that its header names; empty: none, as there is no other
    std::string dialect = "linuxcnc";
    double gougeTolerance = 0.02; ///< mm
    std::size_t exactSamples = 500;
    NcUnits units = NcUnits::millimetre; ///< of the program's text
    ImportOptions import;                ///< worker for the exact distances
    /// Tools that a program may call by their numbers. The milling context's where it calls none; where there are none,
    /// whatever it calls.
    std::vector<Tool> tools;
    /// That the program is to follow, setup frame; null: none is known.
    std::shared_ptr<const std::vector<Path>> promised{};
    double excessTolerance = 0.1; ///< mm, as VerifyRequest::excessTolerance
    bool anyNumber = false;       ///< the one of `tools` is meant by whatever number the program calls
    /// Why a program that its check refuses is wanted all the same, in the user's words; they and what was found stand
    /// in the program's header then. Empty: it is not wanted.
    std::string overrideReason;
    /// What the workpiece was milled with before the program: it is judged on what that left. Null: on a fresh one.
    std::shared_ptr<const ParsedProgram> before{};
};

/// A program that was posted, read back from its text and judged.
struct CheckedProgram {
    std::string text;
    std::string dialect;          ///< that it is read in
    ParsedProgram parsed;         ///< what the text says
    std::vector<Tool> tools;      ///< that it may call by their numbers; one: whatever number it calls
    double gougeTolerance = 0.0;  ///< mm, that it was judged by
    double excessTolerance = 0.0; ///< the same, as ProgramRequest has it
    std::vector<LintMark> lint;   ///< what the control may not take
    std::vector<Moment> moments;  ///< of the hand, behind each motion; empty where the text was not posted from a path
    VerifyReport report;
    VolumeSnapshot machined; ///< the workpiece as the program leaves it
    bool overridden = false; ///< refused, and its header says why it is wanted all the same
    std::size_t slowed = 0;  ///< moves that are fed slower than their path says, for spindle and tool (Path::leastFeed)

    /// What the check found, and what the control would reject; warnings are not among them.
    std::size_t errorCount() const noexcept;
    bool passed() const noexcept { return errorCount() == 0; }
    const Tool* toolNumbered(int number) const noexcept; ///< null: unknown
    /// It may leave the house.
    bool released() const noexcept { return passed() || overridden; }
};

/// What a program is made of: paths in the order in which they are milled, and each tool that they use, once.
struct ProgramPaths {
    std::vector<Path> paths;
    std::vector<Tool> tools;
};

/// Comment lines that a program of these tools begins with: part, setup, stock, zero, tools.
/// @param setupName as ProgramRequest::setupName
std::vector<std::string> programHeader(const MillingContext& milling, const std::vector<Tool>& tools,
                                       const std::string& setupName);

/// That a program is of a length that a machine could mill: what reads its moves takes time and memory with it. Errors:
/// programSyntax, with the line where it is not. @param origin file name for messages
Result<void> checkLength(const ParsedProgram& program, const std::string& origin);

/// Whether a text says in its header that Burin posted it: it is then to follow the project's paths.
bool isPosted(std::string_view text);

/// Posts paths, reads the text back with Burin's own parser and re-simulates it. Where that finds moves that are fed
/// too fast for spindle or tool and their path lets feeds come down (Path::leastFeed), they do, and the program is
/// posted and judged again. What is not `released` must not reach a machine. Errors: those of toProgram, the dialect,
/// parseProgram and verify. Also argumentInvalid: two tools of one number.
Result<CheckedProgram> makeProgram(const MillingContext& milling, const ProgramPaths& paths,
                                   const ProgramRequest& request, Progress& progress);
/// The same of one path, with the milling context's tool.
Result<CheckedProgram> makeProgram(const MillingContext& milling, const Path& path, const ProgramRequest& request,
                                   Progress& progress);

/// A program that its check refused, with a reason why it is wanted all the same: that and what was found stand in its
/// header, and what was found names the lines as they are then. Errors: those of withHeaderComments and parseProgram.
Result<CheckedProgram> overrideCheck(CheckedProgram program, const std::string& reason, const MachineProfile& machine);

/// Judges the text of a program on a milling context. @param origin file name for messages
Result<CheckedProgram> checkProgram(const MillingContext& milling, std::string text, const std::string& origin,
                                    const ProgramRequest& request, Progress& progress);

} // namespace burin
