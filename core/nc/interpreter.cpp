// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/nc/interpreter.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

constexpr std::size_t mostMoves = 20'000'000;

} // namespace

Interpreter::Interpreter(const Control& control, const MachineState& start)
    : control_(control), state_(control, start), writer_(state_, program) {}

bool Interpreter::fail(ProgramProblem problem, std::uint32_t column) {
    *fault_ = {problem, std::max(column, 1u), 1};
    return false;
}

bool Interpreter::run(const Block& block, std::uint32_t line, BlockFault& fault) {
    fault_ = &fault;
    line_ = line;
    writer_.beginBlock(line);
    if (program.motions.size() > mostMoves) return fail(ProgramProblem::tooManyMoves, block.firstColumn);
    ++program.blocks;
    if (!carryOut(block)) {
        nameCauses(fault);
        return false;
    }
    for (const Axis axis : control_.axes)
        if (block.word(axis).given()) setOn_[axis] = line;
    return true;
}

void Interpreter::nameCauses(BlockFault& fault) const {
    const bool ofArc =
        fault.problem == ProgramProblem::arcRadiusDiffers || fault.problem == ProgramProblem::arcRadiusTooSmall;
    if (ofArc)
        fault.starts = {setOn_[linearAxis((state_.planeAxis + 1) % 3)], setOn_[linearAxis((state_.planeAxis + 2) % 3)]};
    const bool ofMode =
        fault.problem == ProgramProblem::placeUnknown || fault.problem == ProgramProblem::machineFrameMotion;
    if (ofArc || ofMode) fault.incrementalSince = incrementalSince_;
}

bool Interpreter::carryOut(const Block& block) {
    return checkCodes(block) && checkWords(block) && checkUse(block) && feedAndSpeed(block) && toolChange(block) &&
           spindleAndCoolant(block) && dwell(block) && planeAndUnits(block) && lengthOffset(block) &&
           workOffset(block) && modes(block) && once(block) && motion(block) && stop(block);
}

void Interpreter::note(NcSettingKind kind, int value) {
    program.settings.push_back({kind, value, line_, program.motions.size()});
}

/// A feed together with a change of units is refused: controls differ in which unit it has.
bool Interpreter::feedAndSpeed(const Block& block) {
    const Word& feed = block.word('F');
    const Code& mode = block.code(GGroup::feedMode);
    const Code& units = block.code(GGroup::units);
    double length = state_.length;
    if (units.given()) {
        length = units.number == gcode::inch || units.number == gcode::inchByG70 ? millimetresPerInch : 1.0;
        if (feed.given() && length != state_.length) // units that are not stated yet are assumed to be millimetres
            return fail(ProgramProblem::unitsChangeBesideFeed, feed);
    }
    if (mode.given()) {
        const FeedMode next = mode.number == gcode::inverseTime     ? FeedMode::inverseTime
                              : mode.number == gcode::perRevolution ? FeedMode::perRevolution
                                                                    : FeedMode::perMinute;
        if (next != state_.feedMode) state_.feed = 0.0; // the value has another meaning in the new mode
        state_.feedMode = next;
    }
    if (feed.given()) state_.feed = feed.value * (state_.feedMode == FeedMode::inverseTime ? 1.0 : length);
    if (const Word& speed = block.word('S'); speed.given()) {
        state_.spindleSpeed = speed.value;
        program.maximumSpindleSpeed = std::max(program.maximumSpindleSpeed, speed.value);
    }
    if (block.word('T').given()) {
        state_.selectedTool = static_cast<int>(block.word('T').value);
        note(NcSettingKind::toolSelected, state_.selectedTool);
    }
    return true;
}

bool Interpreter::toolChange(const Block& block) {
    const Code& code = block.code(MGroup::toolChange);
    if (!code.given()) return true;
    if (code.number == 610) { // assigns a number to the tool in the spindle: nothing moves
        if (!block.word('Q').given()) return fail(ProgramProblem::toolNotSelected, code);
        state_.tool = static_cast<int>(block.word('Q').value);
        note(NcSettingKind::toolChange, state_.tool);
        return true;
    }
    state_.tool = state_.selectedTool;
    note(NcSettingKind::toolChange, state_.tool);
    state_.spindle = SpindleState::off;
    state_.mist = state_.flood = false;
    state_.frames.forgetPlace();
    return true;
}

bool Interpreter::spindleAndCoolant(const Block& block) {
    if (const Code& code = block.code(MGroup::spindle); code.given()) {
        state_.spindle = code.number == 30   ? SpindleState::clockwise
                         : code.number == 40 ? SpindleState::anticlockwise
                                             : SpindleState::off;
        note(NcSettingKind::spindle, static_cast<int>(state_.spindle));
    }
    if (const Code& code = block.code(MGroup::coolant); code.given()) {
        state_.mist = code.number == 70 || (state_.mist && code.number == 80);
        state_.flood = code.number == 80 || (state_.flood && code.number == 70);
    }
    return true;
}

bool Interpreter::dwell(const Block& block) {
    const Code& code = block.code(GGroup::once);
    if (code.number != gcode::dwell) return true;
    const bool byX = control_.dwellByX && block.word('X').given();
    const Word& time = byX ? block.word('X') : block.word('P');
    if (!time.given()) return fail(ProgramProblem::dwellMissing, code);
    if (time.value < 0.0) return fail(ProgramProblem::numberNegative, time);
    const bool milliseconds = !byX && (control_.dwellUnit == DwellUnit::milliseconds ||
                                       (control_.dwellUnit == DwellUnit::pointDecides && !time.point));
    writer_.dwell(milliseconds ? time.value / 1000.0 : time.value, code.column);
    return true;
}

bool Interpreter::planeAndUnits(const Block& block) {
    if (const Code& plane = block.code(GGroup::plane); plane.given())
        state_.planeAxis = plane.number == gcode::planeXY ? 2 : plane.number == gcode::planeZX ? 1 : 0;
    if (const Code& units = block.code(GGroup::units); units.given()) {
        state_.length = units.number == gcode::inch || units.number == gcode::inchByG70 ? millimetresPerInch : 1.0;
        state_.unitsStated = true;
    }
    return true;
}

bool Interpreter::modes(const Block& block) {
    if (const Code& code = block.code(GGroup::distance); code.given()) {
        state_.incremental = code.number == gcode::incremental;
        incrementalSince_ = !state_.incremental ? 0 : incrementalSince_ != 0 ? incrementalSince_ : line_;
        note(NcSettingKind::distance, state_.incremental ? 1 : 0);
    }
    if (const Code& code = block.code(GGroup::arcDistance); code.given())
        state_.centresAbsolute = code.number == gcode::absoluteCentres;
    if (const Code& code = block.code(GGroup::retract); code.given())
        state_.retractToHeight = code.number == gcode::retractToHeight;
    if (const Code& code = block.code(GGroup::control); code.given() && control_.blendWords) {
        state_.pathMode = code.number == gcode::exactPath   ? PathMode::exactPath
                          : code.number == gcode::exactStop ? PathMode::exactStop
                                                            : PathMode::blend;
        state_.blendTolerance = block.word('P').given() ? block.word('P').value * state_.length : 0.0;
        const Word& merge = block.word('Q'); // if missing, P applies to both (convert_control_mode of LinuxCNC)
        state_.mergeTolerance = merge.given() ? merge.value * state_.length : state_.blendTolerance;
        note(NcSettingKind::pathControl, static_cast<int>(state_.pathMode));
    }
    return true;
}

PartialPlace Interpreter::axisWords(const Block& block) const {
    PartialPlace words;
    for (const Axis axis : control_.axes)
        if (const Word& word = block.word(axis); word.given()) words[axis] = valueOf(word, axis);
    return words;
}

int Interpreter::motionOf(const Block& block) const noexcept {
    const Code& code = block.code(GGroup::motion);
    if (!code.given()) return state_.motion;
    const bool restores = code.number == gcode::noMotion && control_.cycleCancel == CycleCancel::restoresMotion;
    return restores ? state_.motionBesideCycles : code.number;
}

bool Interpreter::target(const Block& block, AxisValues& place, AxisSet& known) {
    place = state_.frames.place();
    known = state_.frames.known();
    for (const Axis axis : control_.axes) {
        const Word& word = block.word(axis);
        if (!word.given()) continue;
        if (state_.incremental && !known.has(axis)) return fail(ProgramProblem::placeUnknown, word);
        const double zero = state_.incremental ? place[axis] : state_.frames.shift()[axis];
        place.set(axis, zero + valueOf(word, axis));
        known.set(axis);
    }
    return true;
}

bool Interpreter::motion(const Block& block) {
    const Code& code = block.code(GGroup::motion);
    state_.motion = motionOf(block);
    if (!CannedCycles::isCycle(state_.motion)) {
        cycles_.end();
        state_.motionBesideCycles = state_.motion;
    }
    const Code& once = block.code(GGroup::once);
    if (once.given() && once.number != gcode::machineFrame) return true; // that code has used the axis words
    if (block.code(GGroup::lengthOffset).number == gcode::statedLength) return true; // and so has G43.1
    const bool words = block.hasAxis() || block.hasOffset() || block.word('R').given();
    const bool restated =
        code.given() && code.number != gcode::noMotion && code.number != gcode::rapid && code.number != gcode::line;
    if (!words && code.number == gcode::line && control_.bareLineNeedsFeed) return feedSuffices(block, code.column);
    if (!words && !restated) return true;
    if (state_.motion == gcode::noMotion)
        return fail(ProgramProblem::axisWithoutMotion, block.hasAxis() ? block.firstAxis() : block.firstColumn);
    if (once.number == gcode::machineFrame) return machineFrame(block);
    if (CannedCycles::isCycle(state_.motion)) return cycles_.run(block, control_, state_, writer_, *fault_);
    return straight(block);
}

/// Checks the feed of a move at feed.
bool Interpreter::feedSuffices(const Block& block, std::uint32_t column) {
    if (!(state_.feed > 0.0)) return fail(ProgramProblem::feedMissing, column);
    if (state_.feedMode == FeedMode::inverseTime && !block.word('F').given())
        return fail(ProgramProblem::feedMissingInverseTime, column);
    if (state_.feedMode == FeedMode::perRevolution && !state_.spindleTurns())
        return fail(ProgramProblem::spindleStandsStill, column);
    return true;
}

bool Interpreter::straight(const Block& block) {
    AxisValues place;
    AxisSet known;
    if (!target(block, place, known)) return false;
    const std::uint32_t column = block.hasAxis() ? block.firstAxis() : block.firstColumn;
    if (state_.motion != gcode::rapid && !feedSuffices(block, column)) return false;
    if (state_.motion == gcode::rapid || state_.motion == gcode::line) {
        writer_.move(state_.motion == gcode::rapid ? NcMotionKind::rapid : NcMotionKind::line, place, known, column);
        return true;
    }
    ArcWords words;
    if (!readArc(block, state_, control_, place.linear(), known, words, *fault_)) return false;
    writer_.arc(words, place, known, column);
    return true;
}

bool Interpreter::stop(const Block& block) {
    const Code& code = block.code(MGroup::stop);
    program.workOffset = state_.frames.workOffset();
    if (code.number != 20 && code.number != 300) return true;
    program.ended = true;
    if (control_.readsOnBehindEnd) state_.setBack();
    return true;
}

} // namespace burin
