// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/nc/canned_cycles.h"

#include "core/nc/axis_index.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

constexpr double peckClearance = 0.254; // mm: 0.010 in
constexpr int mostRepeats = 10000;
constexpr double mostPecks = 1e4; // of one block; more is a mistake

bool needsDwell(int cycle) noexcept {
    return cycle == 820 || cycle == 860 || cycle == 880 || cycle == 890;
}

} // namespace

/// One cycle of a block with its values resolved: positions in the frame of the work offset, heights in mm.
struct CannedCycles::Hole {
    int cycle = 0;
    std::uint32_t column = 1;
    Axis axis = Axis::z;  ///< of the hole
    AxisValues place;     ///< of the next hole, except for its height
    AxisSet known;        ///< axes that are known there
    AxisValues increment; ///< from one repeat to the next
    AxisValues offset;    ///< of a back bore, across the axis
    double height = 0.0;  ///< R
    double depth = 0.0;
    double clear = 0.0;  ///< height at which the cycle ends
    double travel = 0.0; ///< height of the move to the hole
    double middle = 0.0; ///< top of a back bore
    int repeats = 1;

    AxisValues with(double along) const {
        AxisValues result = place;
        result.set(axis, along);
        return result;
    }
};

bool CannedCycles::isCycle(int motion) noexcept {
    return motion == gcode::peckBreaking || (motion > gcode::noMotion && motion <= 890);
}

void CannedCycles::end() noexcept {
    last_ = gcode::noMotion;
    startHeight_.reset();
}

bool CannedCycles::fail(ProgramProblem problem, std::uint32_t column) {
    *fault_ = {problem, std::max(column, 1u), 1};
    return false;
}

/// Takes a word from this block, or keeps its value from an earlier block of the same cycle.
bool CannedCycles::keep(const Block& block, char letter, std::optional<double>& kept, double factor, bool needed) {
    if (const Word& word = block.word(letter); word.given()) kept = word.value * factor;
    return kept.has_value() || !needed;
}

bool CannedCycles::readHeights(const Block& block, const ModalState& state, Hole& hole) {
    if (!keep(block, 'R', height_, state.length, true)) return fail(ProgramProblem::cycleHeightMissing, hole.column);
    if (!keep(block, letterOf(hole.axis), depth_, state.length, true))
        return fail(ProgramProblem::cycleDepthMissing, hole.column);
    if (!startHeight_) startHeight_ = state.frames.place()[hole.axis];
    const double zero = state.incremental ? *startHeight_ : state.frames.shift()[hole.axis];
    hole.height = *height_ + zero;
    hole.depth = *depth_ + (state.incremental ? hole.height : zero);
    return hole.height >= hole.depth || fail(ProgramProblem::cycleHeightBelowDepth, hole.column);
}

bool CannedCycles::checkWords(const Block& block, const ModalState& state, const Hole& hole) {
    if (!keep(block, 'P', dwell_, 1.0, needsDwell(hole.cycle)))
        return fail(ProgramProblem::cycleWordMissing, hole.column);
    const bool pecks = hole.cycle == gcode::peckBreaking || hole.cycle == 830;
    if (!keep(block, 'Q', step_, state.length, pecks)) return fail(ProgramProblem::cycleWordMissing, hole.column);
    if (pecks && (!(*step_ > 0.0) || (hole.height - hole.depth) / *step_ * hole.repeats > mostPecks))
        return fail(ProgramProblem::cycleStep, hole.column);
    const bool turns = state.spindleTurns();
    const bool needsSpindle = hole.cycle == 840 || hole.cycle == 860 || hole.cycle == 870 || hole.cycle == 880;
    if ((needsSpindle && !turns) || (hole.cycle == 840 && state.spindle != SpindleState::clockwise))
        return fail(ProgramProblem::cycleSpindle, hole.column);
    return true;
}

bool CannedCycles::readWords(const Block& block, const Control& control, const ModalState& state, Hole& hole) {
    const Word& repeats =
        control.repeatsByK && block.word('K').given() && hole.cycle != 870 ? block.word('K') : block.word('L');
    if (repeats.given()) {
        if (!(repeats.value >= 1.0 && repeats.value <= mostRepeats) || repeats.value != std::floor(repeats.value))
            return fail(ProgramProblem::cycleRepeats, repeats.column);
        hole.repeats = static_cast<int>(repeats.value);
    }
    for (const Axis axis : control.axes) {
        const Word& word = block.word(axis);
        if (axis == hole.axis || !word.given()) continue;
        const double value = isRotary(axis) ? word.value : word.value * state.length;
        if (state.incremental)
            hole.increment.set(axis, value);
        else
            hole.place.set(axis, value + state.frames.shift()[axis]);
    }
    if (hole.cycle != 870) return true;
    for (const Axis axis : linearAxes) {
        const int component = static_cast<int>(axis);
        if (!keep(block, static_cast<char>('I' + component), offset_[axisIndex(component)], state.length, true))
            return fail(ProgramProblem::cycleWordMissing, hole.column);
        if (axis == hole.axis)
            hole.middle =
                *offset_[axisIndex(component)] + (state.incremental ? hole.depth : state.frames.shift()[axis]);
        else
            hole.offset.set(axis, *offset_[axisIndex(component)]);
    }
    return true;
}

bool CannedCycles::run(const Block& block, const Control& control, ModalState& state, MotionWriter& writer,
                       BlockFault& fault) {
    fault_ = &fault;
    if (state.motion != last_) {
        height_.reset();
        depth_.reset();
        dwell_.reset();
        step_.reset();
        offset_ = {};
        last_ = state.motion;
    }
    Hole hole;
    hole.cycle = state.motion;
    hole.column = block.hasAxis() ? block.firstAxis() : block.firstColumn;
    hole.axis = linearAxis(state.planeAxis);
    hole.place = state.frames.place();
    hole.known = state.frames.known();
    for (const Axis axis : control.axes) {
        // The position of the hole and the height from which the tool comes have to be known.
        const bool stated = !state.incremental && axis != hole.axis && block.word(axis).given();
        if (stated) hole.known.set(axis);
        if (linearAxes.has(axis) && !hole.known.has(axis)) return fail(ProgramProblem::placeUnknown, hole.column);
    }
    if (state.feedMode == FeedMode::inverseTime) return fail(ProgramProblem::cycleFeedMode, hole.column);
    if (!(state.feed > 0.0)) return fail(ProgramProblem::feedMissing, hole.column);
    if (!readHeights(block, state, hole) || !readWords(block, control, state, hole) || !checkWords(block, state, hole))
        return false;
    hole.travel = state.retractToHeight ? state.frames.place()[hole.axis] : *startHeight_;
    if (*startHeight_ < hole.height) {
        AxisValues up = state.frames.place();
        up.set(hole.axis, hole.height);
        writer.move(NcMotionKind::rapid, up, state.frames.known(), hole.column);
        hole.travel = hole.height;
    }
    hole.travel = std::max(hole.travel, hole.height);
    hole.clear = state.retractToHeight ? hole.height : std::max(*startHeight_, hole.height);
    for (int repeat = 0; repeat < hole.repeats; ++repeat) {
        hole.place = hole.place + hole.increment;
        writer.move(NcMotionKind::rapid, hole.with(hole.travel), hole.known, hole.column);
        if (hole.travel != hole.height)
            writer.move(NcMotionKind::rapid, hole.with(hole.height), hole.known, hole.column);
        drill(hole, state, writer);
        hole.travel = hole.clear;
    }
    return true;
}

void CannedCycles::drill(const Hole& hole, ModalState& state, MotionWriter& writer) const {
    const auto feed = [&](double along) { writer.move(NcMotionKind::line, hole.with(along), hole.known, hole.column); };
    const auto rapid = [&](double along) {
        writer.move(NcMotionKind::rapid, hole.with(along), hole.known, hole.column);
    };
    const SpindleState turning = state.spindle;
    switch (hole.cycle) {
    case gcode::peckBreaking:
    case 830:
        peck(hole, writer);
        break;
    case 840:
        tap(hole, state, writer);
        break;
    case 850:
        feed(hole.depth);
        feed(hole.height); // retracts at feed up to R
        rapid(hole.clear);
        break;
    case 860:
        feed(hole.depth);
        writer.dwell(*dwell_, hole.column);
        state.spindle = SpindleState::off;
        rapid(hole.clear);
        state.spindle = turning;
        break;
    case 870:
        boreBack(hole, state, writer);
        break;
    case 880: // the operator retracts the tool by hand to the clear height
        feed(hole.depth);
        writer.dwell(*dwell_, hole.column);
        state.frames.moveTo(hole.with(hole.clear), hole.known);
        break;
    case 890:
        feed(hole.depth);
        writer.dwell(*dwell_, hole.column);
        feed(hole.clear);
        break;
    default: // G81, G82
        feed(hole.depth);
        if (hole.cycle == 820) writer.dwell(*dwell_, hole.column);
        rapid(hole.clear);
        break;
    }
}

void CannedCycles::peck(const Hole& hole, MotionWriter& writer) const {
    const auto rapid = [&](double along) {
        writer.move(NcMotionKind::rapid, hole.with(along), hole.known, hole.column);
    };
    for (double depth = hole.height - *step_; depth > hole.depth; depth -= *step_) {
        writer.move(NcMotionKind::line, hole.with(depth), hole.known, hole.column);
        if (hole.cycle == 830) rapid(hole.height); // clears the chips
        rapid(depth + peckClearance);
    }
    writer.move(NcMotionKind::line, hole.with(hole.depth), hole.known, hole.column);
    rapid(hole.clear);
}

/// Feeds in with the spindle clockwise, and out with it anticlockwise.
void CannedCycles::tap(const Hole& hole, ModalState& state, MotionWriter& writer) const {
    writer.move(NcMotionKind::line, hole.with(hole.depth), hole.known, hole.column);
    state.spindle = SpindleState::anticlockwise;
    if (dwell_) writer.dwell(*dwell_, hole.column);
    writer.move(NcMotionKind::line, hole.with(hole.clear), hole.known, hole.column);
    state.spindle = SpindleState::clockwise;
}

/// Passes through the hole off its axis with the spindle oriented, then bores from below.
void CannedCycles::boreBack(const Hole& hole, ModalState& state, MotionWriter& writer) const {
    const auto go = [&](NcMotionKind kind, const AxisValues& target) {
        writer.move(kind, target, hole.known, hole.column);
    };
    const SpindleState turning = state.spindle;
    go(NcMotionKind::rapid, hole.with(hole.height) + hole.offset);
    state.spindle = SpindleState::off;
    go(NcMotionKind::rapid, hole.with(hole.depth) + hole.offset);
    go(NcMotionKind::rapid, hole.with(hole.depth));
    state.spindle = turning;
    go(NcMotionKind::line, hole.with(hole.middle));
    go(NcMotionKind::line, hole.with(hole.depth));
    state.spindle = SpindleState::off;
    go(NcMotionKind::rapid, hole.with(hole.depth) + hole.offset);
    go(NcMotionKind::rapid, hole.with(hole.clear) + hole.offset);
    go(NcMotionKind::rapid, hole.with(hole.clear));
    state.spindle = turning;
}

} // namespace burin
