// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/machine/machine_profile.h"
#include "core/nc/control.h"

#include <string>
#include <vector>

namespace burin {

enum class LintSeverity : std::uint8_t {
    warning, ///< the control may take it, but what it does then is not in the text alone
    error    ///< the control would reject it, or it would do harm
};

/// A place of a program's text that is wrong.
struct LintMark {
    std::uint32_t line = 1, column = 1, length = 1; ///< from 1; characters
    LintSeverity severity = LintSeverity::error;
    ProgramProblem problem = ProgramProblem::characterNotAllowed;
    std::string words; ///< of the program, or figures, that are concerned; empty: none
    std::string text;  ///< English, with the words concerned
};

/// What a program is held against. Pointers may be null: their rules are then left out.
struct LintSubject {
    const Control* control = nullptr; ///< null: LinuxCNC's
    const MachineProfile* machine = nullptr;
};

/// Marks in the order of the text, all that parseProgram would call an error (the first of each block), and what it
/// lets pass: a missing end, missing offsets and units, feeds and speeds beyond the machine's. At most `mostMarks`. Any
/// text may be given; linear in its length. Nothing throws.
std::vector<LintMark> lint(std::string_view text, const LintSubject& subject);
inline constexpr std::size_t mostMarks = 1000;

} // namespace burin
