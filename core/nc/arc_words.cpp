// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/nc/arc_words.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

constexpr double noChord = 1e-9;   // mm
constexpr double noRadius = 0.001; // mm: the smallest R that is accepted
constexpr std::array<char, 3> offsetLetters{'I', 'J', 'K'};

class ArcReader {
public:
    ArcReader(const Block& block, const ModalState& state, const Control& control, ArcWords& words, BlockFault& fault)
        : block_(block), state_(state), control_(control), words_(words), fault_(fault) {
        column_ = block.hasAxis() ? block.firstAxis() : block.firstOffset();
        if (column_ == 0) column_ = block.word('R').given() ? block.word('R').column : block.firstColumn;
    }

    bool read(AxisSet known) {
        const int axis = words_.arc.axis;
        if (control_.arcNeedsAxis && !block_.word(linearAxis((axis + 1) % 3)).given() &&
            !block_.word(linearAxis((axis + 2) % 3)).given())
            return fail(ProgramProblem::axisMissing, column_);
        for (int i = 0; i < 3; ++i) {
            const bool inPlane = i != axis, stays = words_.arc.to[i] == words_.arc.from[i];
            // A helix needs its start along the axis too, unless it does not move along it.
            if ((inPlane || !stays) && (!state_.frames.known().has(linearAxis(i)) || !known.has(linearAxis(i))))
                return fail(ProgramProblem::placeUnknown, column_);
        }
        const Word& radius = block_.word('R');
        if (radius.given() && block_.hasOffset()) return fail(ProgramProblem::arcRadiusAndCentre, radius.column);
        return turns() && (radius.given() ? byRadius(radius) : byCentre());
    }

private:
    bool fail(ProgramProblem problem, std::uint32_t column) {
        fault_ = {problem, column, 1};
        return false;
    }

    bool turns() {
        const Word& word = block_.word('P');
        if (!word.given()) return true;
        if (!control_.arcTurns) return fail(ProgramProblem::wordWithoutUse, word.column);
        if (word.value < 1.0 || word.value > 1e4 || word.value != std::floor(word.value))
            return fail(ProgramProblem::arcTurns, word.column);
        words_.wholeTurns = static_cast<std::uint32_t>(word.value) - 1;
        return true;
    }

    bool byCentre() {
        Arc& arc = words_.arc;
        int given = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const Word& word = block_.word(offsetLetters[static_cast<std::size_t>(axis)]);
            if (!word.given()) continue;
            if (axis == arc.axis) return fail(ProgramProblem::arcOffsetAcross, word.column);
            arc.centre[axis] = word.value * state_.length +
                               (state_.centresAbsolute ? state_.frames.shift().linear()[axis] : arc.from[axis]);
            ++given;
        }
        if (given == 0 || (state_.centresAbsolute && given < 2)) return fail(ProgramProblem::arcCentreMissing, column_);
        const ArcTurn turn = turnOf(arc);
        if (std::min(turn.startRadius, turn.endRadius) < control_.arcRadius.zero)
            return fail(ProgramProblem::arcRadiusZero, column_);
        return control_.arcRadius.acceptsRadii(turn.startRadius, turn.endRadius, state_.inch()) ||
               fail(ProgramProblem::arcRadiusDiffers, column_);
    }

    /// A negative R selects the longer one of the two arcs.
    bool byRadius(const Word& word) {
        Arc& arc = words_.arc;
        const int u = (arc.axis + 1) % 3, v = (arc.axis + 2) % 3;
        const double radius = std::abs(word.value) * state_.length;
        if (radius < noRadius) return fail(ProgramProblem::arcRadiusZero, word.column);
        const double du = arc.to[u] - arc.from[u], dv = arc.to[v] - arc.from[v];
        const double half = 0.5 * std::hypot(du, dv);
        if (half < noChord) return fail(ProgramProblem::arcRadiusFullTurn, word.column);
        if (half - radius > control_.arcRadius.shortBy) return fail(ProgramProblem::arcRadiusTooSmall, word.column);
        const double height = half < radius ? std::sqrt((radius - half) * (radius + half)) : 0.0;
        // The centre of a short anticlockwise arc lies to the left of its chord.
        const double side = (arc.clockwise ? -1.0 : 1.0) * (word.value < 0.0 ? -1.0 : 1.0) * height / (2.0 * half);
        arc.centre[u] = 0.5 * (arc.from[u] + arc.to[u]) - side * dv;
        arc.centre[v] = 0.5 * (arc.from[v] + arc.to[v]) + side * du;
        return true;
    }

    const Block& block_;
    const ModalState& state_;
    const Control& control_;
    ArcWords& words_;
    BlockFault& fault_;
    std::uint32_t column_ = 1;
};

} // namespace

bool readArc(const Block& block, const ModalState& state, const Control& control, const glm::dvec3& target,
             AxisSet known, ArcWords& words, BlockFault& fault) {
    const glm::dvec3& from = state.frames.place().linear();
    words = {{from, target, from, state.planeAxis, state.motion == gcode::clockwise}, 0};
    return ArcReader(block, state, control, words, fault).read(known);
}

} // namespace burin
