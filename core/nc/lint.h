// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/machine/machine_profile.h"
#include "core/nc/control.h"

#include <string>
#include <vector>

namespace burin {

enum class LintSeverity : std::uint8_t {
    warning, ///< the control may accept it, but the effect does not follow from the text alone
    error    ///< the control would reject it, or it would cause damage
};

/// A position in the text of a program that has a problem.
struct LintMark {
    std::uint32_t line = 1, column = 1, length = 1; ///< from 1; characters
    LintSeverity severity = LintSeverity::error;
    ProgramProblem problem = ProgramProblem::characterNotAllowed;
    std::string words; ///< words of the program, or numbers, that are concerned; empty: none
    std::string text;  ///< English, with the words concerned
};

/// What a program is checked against. Pointers may be null: the rules for them are then skipped.
struct LintSubject {
    const Control* control = nullptr; ///< null: LinuxCNC's
    const MachineProfile* machine = nullptr;
};

/// The problems in the order of the text: all that parseProgram would report as an error (the first of each block), and
/// what it accepts: a missing end, missing offsets and units, feeds and speeds beyond the machine's. At most
/// `mostMarks`. Accepts any text; linear in its length. Nothing throws.
std::vector<LintMark> lint(std::string_view text, const LintSubject& subject);
inline constexpr std::size_t mostMarks = 1000;

} // namespace burin
