// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/project.h"
#include "core/job/milling_context.h"
#include "core/recording/generated_moves.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// The moves of a program with one tool between two tool changes, as a source of a path.
struct ProgramPass {
    Tool tool;
    Coolant coolant = Coolant::off; ///< of the first move with coolant
    bool coolantChanges = false;    ///< not all moves have that coolant; each point of `moves` states its own
    bool tilted = false;            ///< the tool is not upright on all moves: it is a ball
    GeneratedMoves moves;           ///< feed moves; no id yet
    double length = 0.0;            ///< mm, of these moves
};

/// A program as sources of paths. Rapids are left out: links replace them.
struct ProgramPasses {
    std::vector<ProgramPass> passes; ///< in the program's order; never empty
    std::size_t arcs = 0;            ///< arcs replaced by chords, which deviate by `arcChord` at most
    std::size_t dwells = 0;          ///< left out: paths have no dwells
    std::size_t startless = 0;       ///< feed moves from a position that the program does not state, left out

    std::size_t coolantChanges() const noexcept; ///< number of passes in which the coolant changes
    double length() const noexcept;              ///< mm, of all passes
};

/// The meaning of a program's tool numbers.
struct ToolChoice {
    std::vector<Tool> tools;
    bool anyNumber = false;         ///< any number calls the first tool; otherwise each tool has its own number
    std::optional<Tool> onlyTool{}; ///< for a program that calls one number or none, for any number
};

/// Reads a program, G-code in a dialect or cutter locations, as moves in the setup frame. Thread-safe.
/// @param milling its setup, program zero and machine are used, not its tool
/// @param tools if the program calls no number and there is one tool, that tool is used
/// Errors: those of parseProgram and parseCutterLocations, among them for a tilted tool that is no ball; nameUnknown (a
/// tool number), notSupported (a tool that does not turn), pathEmpty (no feed move), those of checkLength,
/// programSyntax (several work offsets, or one that the program sets), argumentInvalid (a position beyond 1e6 mm),
/// cancelled.
Result<ProgramPasses> passesOfProgram(std::string_view text, const std::string& file, const std::string& dialect,
                                      const MillingContext& milling, const ToolChoice& tools, const Progress& progress);

/// What the edits of a path that is made from a program take from one of its passes.
struct PassUse {
    SetFeed::Cooling cooling = SetFeed::Cooling::off; ///< of all moves; where it changes, as the program states it
    bool tilted = false;                              ///< the axes are those of the program
};
PassUse useOf(const ProgramPass& pass) noexcept;

/// Returns the path with a pass of a program as its last source, with the program's feeds; a path without sources gets
/// the edits of paths that are made from programs. @param name of a new path @param use of the pass: for the
/// edits of a new path, and of another one if the coolant changes within the pass, or the tool is tilted
/// @param source id of the pass in the project
StoredPath withProgram(StoredPath path, const std::string& name, const PassUse& use, std::int64_t source);

} // namespace burin
