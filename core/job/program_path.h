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

/// What a program mills with one tool between two tool changes, as a source of a path.
struct ProgramPass {
    Tool tool;
    Coolant coolant = Coolant::off; ///< of its first move with any
    GeneratedMoves moves;           ///< at feed; no id yet
    double length = 0.0;            ///< mm, of these
};

/// A program as sources of paths. Rapids are not among them: links take their place.
struct ProgramPasses {
    std::vector<ProgramPass> passes; ///< in the program's order; never empty
    std::size_t arcs = 0;            ///< moves that became chords, which leave them by `arcChord` at most
    std::size_t dwells = 0;          ///< left out: paths know none
    std::size_t startless = 0;       ///< feed moves from a place that the program does not state, left out

    double length() const noexcept; ///< mm, of all of them
};

/// What a program's tool numbers mean.
struct ToolChoice {
    std::vector<Tool> tools;
    bool anyNumber = false;         ///< the first one, whatever number is called; else each by its own
    std::optional<Tool> onlyTool{}; ///< of a program that calls one number or none, whatever that is
};

/// Reads a program, G-code in a dialect or cutter locations, as moves of the setup frame. Any thread.
/// @param milling its setup, program zero and machine count, not its tool
/// @param tools without a number called, and one of them: that one
/// Errors: those of parseProgram and parseCutterLocations; nameUnknown (a tool number), pathEmpty (no move at feed),
/// those of checkLength, programSyntax (several work offsets, or one that the program sets), argumentInvalid (a place
/// beyond 1e6 mm), cancelled.
Result<ProgramPasses> passesOfProgram(std::string_view text, const std::string& file, const std::string& dialect,
                                      const MillingContext& milling, const ToolChoice& tools, const Progress& progress);

/// A path with a pass of a program as its last source, fed as the program states; one without sources gets the edits of
/// paths that are made of programs. @param name of a new one @param coolant of a new one's edits @param source its id
/// in the project
StoredPath withProgram(StoredPath path, const std::string& name, Coolant coolant, std::int64_t source);

} // namespace burin
