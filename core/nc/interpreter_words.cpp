// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// The checks of Interpreter before it executes a block: words that nothing uses are errors, never ignored.
#include "core/nc/interpreter.h"

#include <cmath>

namespace burin {
namespace {

/// The non-modal codes that read X Y Z.
bool readsAxes(int once) noexcept {
    return once == gcode::setOffset || once == gcode::home || once == gcode::secondHome || once == gcode::localShift ||
           once == gcode::shift;
}

} // namespace

bool Interpreter::checkCodes(const Block& block) {
    const Code& compensation = block.code(GGroup::compensation);
    if (compensation.given() && compensation.number != gcode::noCompensation)
        return fail(ProgramProblem::cutterCompensation, compensation);
    if (const Code& code = block.code(MGroup::subprogram); code.given()) return fail(ProgramProblem::subprogram, code);
    const Code& once = block.code(GGroup::once);
    const Code& motion = block.code(GGroup::motion);
    const Code& length = block.code(GGroup::lengthOffset);
    if (readsAxes(once.number)) {
        if (motion.given() && motion.number != gcode::noMotion) return fail(ProgramProblem::codeReadsAxes, motion);
        if (length.number == gcode::statedLength) return fail(ProgramProblem::codeReadsAxes, length);
    }
    if (length.number == gcode::statedLength && motion.given() && motion.number != gcode::noMotion && block.hasAxis())
        return fail(ProgramProblem::codeReadsAxes, motion);
    if (once.number == gcode::dwell && !(control_.dwellByX && block.word('X').given())) {
        if (block.hasAxis() || block.hasOffset() || (motion.given() && motion.number != gcode::noMotion))
            return fail(ProgramProblem::dwellMoves, once);
    }
    return true;
}

/// Checks numbers that must not be negative, or must be integers.
bool Interpreter::checkWords(const Block& block) {
    for (const char letter : {'F', 'S', 'T', 'H', 'D', 'L', 'E'}) {
        if (block.word(letter).given() && block.word(letter).value < 0.0)
            return fail(ProgramProblem::numberNegative, block.word(letter));
    }
    if (block.word('P').given() && block.word('P').value < 0.0)
        return fail(ProgramProblem::numberNegative, block.word('P'));
    for (const char letter : {'T', 'H', 'L', 'O'}) {
        const Word& word = block.word(letter);
        if (word.given() && word.value != std::floor(word.value)) return fail(ProgramProblem::numberNotWhole, word);
    }
    return true;
}

/// Checks words that have no meaning without another one.
bool Interpreter::checkUse(const Block& block) {
    const int motion = motionOf(block);
    const int once = block.code(GGroup::once).number;
    const bool moves = once < 0 || once == gcode::machineFrame;
    const bool arc = moves && (motion == gcode::clockwise || motion == gcode::anticlockwise);
    const bool cycle = moves && CannedCycles::isCycle(motion);
    const bool waits = cycle && (motion == 820 || motion == 840 || motion == 860 || motion == 880 || motion == 890);
    const bool pecks = cycle && (motion == gcode::peckBreaking || motion == 830);
    const bool boresBack = cycle && motion == 870;
    const bool blends = block.code(GGroup::control).number == gcode::blend;
    const bool smooths = block.code(GGroup::smoothing).given();
    const int offset = block.code(GGroup::workOffset).number;
    const bool sets = once == gcode::setOffset;
    const bool further = offset == gcode::furtherOffset || offset == gcode::furtherOffsetHaas;
    // Lengths, which a control would read in its smallest steps; K and R may be counts.
    for (const char letter : {'X', 'Y', 'Z', 'I', 'J', 'K', 'R'}) {
        const Word& word = block.word(letter);
        const bool counts = (letter == 'K' && cycle && !boresBack) || (letter == 'R' && smooths);
        if (control_.pointNeeded && word.given() && !word.point && word.value != 0.0 && !counts)
            return fail(ProgramProblem::pointMissing, word);
    }
    struct Use {
        char letter;
        bool used;
    };
    const std::array<Use, 10> uses{{
        {'H', block.code(GGroup::lengthOffset).number == gcode::lengthOffset},
        {'D', false}, // only of G41 and G42
        {'L', sets || cycle},
        {'P', once == gcode::dwell || (blends && control_.blendWords) || sets || further || smooths || waits || arc ||
                  once == gcode::secondHome},
        {'Q', (blends && control_.blendWords) || pecks || smooths || block.code(MGroup::toolChange).number == 610},
        {'R', arc || cycle || sets || smooths},
        {'E', smooths},
        {'I', arc || boresBack},
        {'J', arc || boresBack},
        {'K', arc || boresBack || (cycle && control_.repeatsByK)},
    }};
    for (const Use& use : uses) {
        const Word& word = block.word(use.letter);
        if (!word.given() || use.used) continue;
        const bool centre = use.letter >= 'I' && use.letter <= 'K';
        return fail(centre ? ProgramProblem::arcOffsetWithoutArc : ProgramProblem::wordWithoutUse, word);
    }
    if (once == gcode::dwell && blends && block.word('P').given())
        return fail(ProgramProblem::wordWithoutUse, block.word('P'));
    return true;
}

} // namespace burin
