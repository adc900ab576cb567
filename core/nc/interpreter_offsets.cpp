// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// The part of Interpreter that deals with frames: offsets, shifts, homes.
#include "core/nc/interpreter.h"

#include <cmath>

namespace burin {
namespace {

constexpr std::array<int, 9> offsetsInOrder{54, 55, 56, 57, 58, 59, 591, 592, 593};
constexpr int furtherOffsetsBegin = 1000; // NcMotion::workOffset

} // namespace

bool Interpreter::lengthOffset(const Block& block) {
    const Code& code = block.code(GGroup::lengthOffset);
    if (!code.given()) return true;
    if (code.number == gcode::noLengthOffset) {
        state_.frames.setLengthOffset(0, 0.0);
    } else if (code.number == gcode::statedLength) {
        const Word& length = block.word('Z');
        if (!length.given() || block.word('X').given() || block.word('Y').given())
            return fail(ProgramProblem::axisMissing, code);
        state_.frames.setLengthOffset(-1, length.value * state_.length);
    } else {
        const Word& word = block.word('H');
        const int number = word.given() ? static_cast<int>(word.value) : state_.tool;
        state_.frames.setLengthOffset(number,
                                      number == 0 ? std::optional<double>(0.0) : state_.frames.lengthOf(number));
    }
    note(NcSettingKind::lengthOffset, state_.frames.lengthOffsetNumber());
    return true;
}

bool Interpreter::workOffset(const Block& block) {
    const Code& code = block.code(GGroup::workOffset);
    if (!code.given()) return true;
    int number = code.number % 10 == 0 ? code.number / 10 : code.number;
    if (code.number == gcode::furtherOffset || code.number == gcode::furtherOffsetHaas) {
        const Word& which = block.word('P');
        if (!which.given()) return fail(ProgramProblem::workOffsetMissing, code);
        if (which.value < 1.0 || which.value > 300.0 || which.value != std::floor(which.value))
            return fail(ProgramProblem::numberOutOfRange, which);
        number = furtherOffsetsBegin + static_cast<int>(which.value);
    } else if (code.number >= 1100) { // G110 is G154 P1
        number = furtherOffsetsBegin + code.number / 10 - 109;
    }
    state_.frames.setWorkOffset(number);
    note(NcSettingKind::workOffset, number);
    return true;
}

bool Interpreter::once(const Block& block) {
    const Code& code = block.code(GGroup::once);
    switch (code.number) {
    case gcode::setOffset:
        return setOffset(block);
    case gcode::home:
    case gcode::secondHome:
        return home(block, code);
    case gcode::storeHome:
    case gcode::storeSecondHome:
        state_.frames.storeHome(code.number == gcode::storeHome ? 0 : 1);
        return true;
    case gcode::localShift:
    case gcode::shift:
    case gcode::dropShift:
    case gcode::pauseShift:
    case gcode::restoreShift:
        return shift(block, code);
    default:
        return true;
    }
}

bool Interpreter::setOffset(const Block& block) {
    const Code& code = block.code(GGroup::once);
    const Word &how = block.word('L'), &which = block.word('P');
    if (!how.given() || !which.given()) return fail(ProgramProblem::workOffsetMissing, code);
    if (how.value != 2.0 && how.value != 20.0) return fail(ProgramProblem::codeNotRead, how);
    if (which.value < 0.0 || which.value > static_cast<double>(offsetsInOrder.size()) ||
        which.value != std::floor(which.value))
        return fail(ProgramProblem::numberOutOfRange, which);
    const auto order = static_cast<std::size_t>(which.value);
    const int number = order == 0 ? state_.frames.workOffset() : offsetsInOrder[order - 1];
    if (how.value == 2.0) {
        if (block.word('R').given()) return fail(ProgramProblem::wordWithoutUse, block.word('R')); // a rotated frame
        state_.frames.writeWorkOffset(number, axisWords(block));
    } else {
        state_.frames.writeWorkOffsetHere(number, axisWords(block));
    }
    return true;
}

/// Moves home by way of the position that the axis words name; only their axes move, or all axes without any.
bool Interpreter::home(const Block& block, const Code& code) {
    const std::size_t which = code.number == gcode::home ? 0 : 1;
    // Incrementally from an unknown position (G28 G91 Z0): the intermediate position stays unknown, but does not
    // matter.
    AxisValues place = state_.frames.place();
    AxisSet known = state_.frames.known();
    for (const Axis axis : control_.axes) {
        const Word& word = block.word(axis);
        if (!word.given()) continue;
        if (!state_.incremental) {
            place.set(axis, valueOf(word, axis) + state_.frames.shift()[axis]);
            known.set(axis);
        } else if (known.has(axis)) {
            place.set(axis, place[axis] + valueOf(word, axis));
        }
    }
    writer_.move(NcMotionKind::rapid, place, known, code.column);
    place = state_.frames.place();
    known = state_.frames.known();
    for (const Axis axis : control_.axes) {
        if (block.hasAxis() && !block.word(axis).given()) continue;
        const std::optional<double>& home = state_.frames.home(which)[axis];
        const std::optional<double> there = home ? state_.frames.fromMachine(axis, *home) : std::nullopt;
        known.set(axis, there.has_value());
        if (there) place.set(axis, *there);
    }
    writer_.move(NcMotionKind::rapid, place, known, code.column);
    return true;
}

bool Interpreter::shift(const Block& block, const Code& code) {
    const bool sets = code.number != gcode::dropShift && code.number != gcode::pauseShift;
    note(NcSettingKind::shift, sets ? 1 : 0);
    switch (code.number) {
    case gcode::shift:
    case gcode::localShift:
        if (!block.hasAxis()) return fail(ProgramProblem::axisMissing, code);
        if (code.number == gcode::shift)
            state_.frames.shiftSoThatHereIs(axisWords(block));
        else
            state_.frames.setShift(axisWords(block));
        return true;
    case gcode::restoreShift:
        state_.frames.restoreShift();
        return true;
    default:
        state_.frames.dropShift(code.number == gcode::pauseShift);
        return true;
    }
}

bool Interpreter::machineFrame(const Block& block) {
    const Code& code = block.code(GGroup::once);
    if (state_.motion != gcode::rapid && state_.motion != gcode::line)
        return fail(ProgramProblem::machineFrameMotion, code);
    if (state_.incremental && block.hasAxis()) return fail(ProgramProblem::machineFrameMotion, code);
    if (state_.motion == gcode::line && !(state_.feed > 0.0)) return fail(ProgramProblem::feedMissing, code);
    AxisValues place = state_.frames.place();
    AxisSet known = state_.frames.known();
    for (const Axis axis : control_.axes) {
        const Word& word = block.word(axis);
        if (!word.given()) continue;
        const std::optional<double> there = state_.frames.fromMachine(axis, valueOf(word, axis));
        known.set(axis, there.has_value());
        if (there) place.set(axis, *there);
    }
    writer_.move(state_.motion == gcode::rapid ? NcMotionKind::rapid : NcMotionKind::line, place, known, code.column);
    return true;
}

} // namespace burin
