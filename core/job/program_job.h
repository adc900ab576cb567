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

/// Returns the strokes of a stored path's sources, in the path's order. Errors: those of Project::visitSamples,
/// StrokeReader and Project::generatedMoves; outOfMemory, before anything is read, if the path would need more memory
/// than available.
Result<std::vector<SourceStrokes>> strokesOf(const Project& project, const StoredPath& path);
/// Evaluates a stored path on a milling context, with its sides and what it clears.
/// @param strokes   of the path; moved from where possible
/// @param before paths milled before it, in order: stock for feed optimisation, low links and sides
/// Errors: those of evaluate, millingSides, cuttingConditions and MilledStock::lend.
Result<EvaluatedPath> evaluateStored(std::vector<SourceStrokes> strokes, const MillingContext& milling,
                                     const Tool& tool, const StoredPath& path, std::span<const MilledPath> before,
                                     Progress& progress, const EvaluationHelp& help = {});
/// The same with the milling context's tool and sources from a project, as if it were the only path.
/// Errors: also those of strokesOf.
Result<EvaluatedPath> evaluateStored(const Project& project, const MillingContext& milling, const StoredPath& path,
                                     Progress& progress);

struct ProgramRequest {
    std::string name;        ///< of the program
    std::string setupName{}; ///< named in its header; empty: not named, as it is the only one
    std::string dialect = "linuxcnc";
    double gougeTolerance = 0.02; ///< mm
    std::size_t exactSamples = 500;
    NcUnits units = NcUnits::millimetre; ///< of the program's text
    ImportOptions import;                ///< worker for the exact distances
    /// Tools that a program may call by their numbers. The milling context's tool is used if the program calls none; if
    /// this is empty, for any number.
    std::vector<Tool> tools;
    /// Paths that the program is expected to follow, setup frame; null: unknown.
    std::shared_ptr<const std::vector<Path>> promised{};
    double excessTolerance = 0.1; ///< mm, as VerifyRequest::excessTolerance
    bool anyNumber = false;       ///< any number that the program calls means the one tool of `tools`
    /// The user's reason for exporting a program that failed its check; the reason and the findings are written to the
    /// program's header. Empty: such a program is not exported.
    std::string overrideReason;
    /// The program that milled the workpiece before: the check starts from what it left. Null: from unmilled stock.
    std::shared_ptr<const ParsedProgram> before{};
    /// What earlier checks on the same milling context found out, so that only what changed is checked again. Null: all
    /// is. One check at a time.
    std::shared_ptr<KeptCheck> kept{};
};

/// A program that was posted, read back from its text and checked.
struct CheckedProgram {
    std::string text;
    std::string dialect;          ///< in which it is read
    ParsedProgram parsed;         ///< parsed from the text
    std::vector<Tool> tools;      ///< callable by their numbers; a single one: by any number
    double gougeTolerance = 0.0;  ///< mm, used in the check
    double excessTolerance = 0.0; ///< mm, used in the check, as in ProgramRequest
    std::vector<LintMark> lint;   ///< what the control may reject
    std::vector<Moment> moments;  ///< of the hand, per motion; empty if the text was not posted from a path
    VerifyReport report;
    VolumeSnapshot machined; ///< the workpiece after the program
    bool overridden = false; ///< failed the check; the header states why it is used nevertheless
    std::size_t slowed = 0;  ///< moves with a feed lower than in their path, for spindle and tool (Path::leastFeed)

    /// Returns the number of findings of the check and of what the control would reject, without warnings.
    std::size_t errorCount() const noexcept;
    bool passed() const noexcept { return errorCount() == 0; }
    const Tool* toolNumbered(int number) const noexcept; ///< null: unknown
    /// Whether it may be exported.
    bool released() const noexcept { return passed() || overridden; }
};

/// The input of a program: paths in milling order, and each tool that they use, once.
struct ProgramPaths {
    std::vector<Path> paths;
    std::vector<Tool> tools;
};

/// Returns the comment lines at the start of a program with these tools: part, setup, stock, zero, tools.
/// @param setupName as ProgramRequest::setupName
std::vector<std::string> programHeader(const MillingContext& milling, const std::vector<Tool>& tools,
                                       const std::string& setupName);

/// Checks that the length of a program is realistic for a machine, as the time and memory for reading its moves grow
/// with it. Errors: programSyntax, with the line at which it is exceeded. @param origin file name for messages
Result<void> checkLength(const ParsedProgram& program, const std::string& origin);

/// Whether the header of a text states that Burin posted it: the program is then expected to follow the project's
/// paths.
bool isPosted(std::string_view text);

/// Posts paths, reads the text back with Burin's own parser and simulates it. If moves are found whose feed is too high
/// for spindle or tool, and their path allows lower feeds (Path::leastFeed), the feeds are lowered and the program is
/// posted and checked again. A program that is not `released` must not reach a machine. Errors: those of toProgram, the
/// dialect, parseProgram and verify. Also argumentInvalid: two tools with the same number.
Result<CheckedProgram> makeProgram(const MillingContext& milling, const ProgramPaths& paths,
                                   const ProgramRequest& request, Progress& progress);
/// The same for one path, with the milling context's tool.
Result<CheckedProgram> makeProgram(const MillingContext& milling, const Path& path, const ProgramRequest& request,
                                   Progress& progress);

/// Returns a program that failed its check, with the reason for using it nevertheless. The reason and the findings are
/// written to its header; the findings refer to the resulting line numbers. Errors: those of withHeaderComments and
/// parseProgram.
Result<CheckedProgram> overrideCheck(CheckedProgram program, const std::string& reason, const MachineProfile& machine);

/// Checks the text of a program on a milling context. @param origin file name for messages
Result<CheckedProgram> checkProgram(const MillingContext& milling, std::string text, const std::string& origin,
                                    const ProgramRequest& request, Progress& progress);

} // namespace burin
