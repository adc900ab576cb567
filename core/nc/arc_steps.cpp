// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/nc/arc_steps.h"

#include "core/base/units.h"
#include "core/nc/axis_index.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace burin {
namespace {

constexpr double smallestSweep = 1e-3; // rad
constexpr double sweepTolerance = 0.1; // rad: a piece whose sweep differs by more has become another arc
constexpr int mostHalvings = 3;
constexpr double computed = 1e-9; // mm: what a control's own arithmetic may add
/// Largest deviation of the written arc from the true one: this many steps of the last digit, plus this many mm.
constexpr double strayedSteps = 2.0, strayedBeyond = 0.0015; // mm

glm::dvec3 placeOf(const StepPlace& steps, const NumberWords& numbers) {
    return {numbers.millimetresOf(steps[0]), numbers.millimetresOf(steps[1]), numbers.millimetresOf(steps[2])};
}

StepPlace stepsOf(const glm::dvec3& place, const NumberWords& numbers) {
    return {numbers.stepsOf(place.x), numbers.stepsOf(place.y), numbers.stepsOf(place.z)};
}

/// The largest distance, mm, in their plane, of the quarter points of an arc from another arc.
double strayed(const Arc& wanted, const Arc& written) {
    const int u = (wanted.axis + 1) % 3, v = (wanted.axis + 2) % 3;
    const ArcTurn turn = turnOf(wanted), turnWritten = turnOf(written);
    double farthest = 0.0;
    for (const double share : {0.25, 0.5, 0.75}) {
        const glm::dvec3 place = placeOn(wanted, turn, share) - written.centre;
        const double radius = glm::mix(turnWritten.startRadius, turnWritten.endRadius, share);
        farthest = std::max(farthest, std::abs(std::hypot(place[u], place[v]) - radius));
    }
    return farthest;
}

class ArcWriter {
public:
    ArcWriter(const NumberWords& numbers, const DialectArcs& limits) : numbers_(numbers), limits_(limits) {}

    std::vector<StepMove> write(const Arc& arc, const StepPlace& from) {
        at_ = from;
        const ArcTurn turn = turnOf(arc);
        const double radius = std::max(turn.startRadius, turn.endRadius);
        const bool rises = arc.to[arc.axis] != arc.from[arc.axis];
        if (radius > limits_.largestRadius || radius < limits_.smallestRadius || std::abs(turn.sweep) < smallestSweep ||
            limits_.largestSweep < 1.0 || (rises && !limits_.helices)) {
            lines(arc);
            return std::move(moves_);
        }
        const double largest = limits_.largestSweep * pi / 180.0 * (1.0 + 1e-9);
        const int pieces = std::max(1, static_cast<int>(std::ceil(std::abs(turn.sweep) / largest)));
        Arc piece = arc;
        for (int i = 1; i <= pieces; ++i) {
            piece.to = placeOn(arc, turn, static_cast<double>(i) / pieces);
            add(piece, mostHalvings);
            piece.from = piece.to;
        }
        return std::move(moves_);
    }

private:
    void lines(const Arc& arc) {
        std::vector<glm::dvec3> places;
        flatten(arc, lineChord, places);
        for (const glm::dvec3& place : places) {
            const StepPlace to = stepsOf(place, numbers_);
            if (to != at_) moves_.push_back({to, false, {}});
            at_ = to;
        }
    }

    /// Adds one piece, or its halves where it can't be written as it is.
    void add(const Arc& arc, int halvings) {
        if (const std::optional<StepMove> move = written(arc)) {
            moves_.push_back(*move);
            at_ = move->to;
            return;
        }
        if (halvings == 0) return lines(arc);
        const ArcTurn turn = turnOf(arc);
        Arc half = arc;
        half.to = placeOn(arc, turn, 0.5);
        add(half, halvings - 1);
        half.from = half.to;
        half.to = arc.to;
        add(half, halvings - 1);
    }

    /// The arc in written numbers; empty if these would describe another arc.
    std::optional<StepMove> written(const Arc& arc) const {
        const int u = (arc.axis + 1) % 3, v = (arc.axis + 2) % 3;
        StepMove move{stepsOf(arc.to, numbers_), true, {}};
        Arc rounded = arc;
        rounded.from = placeOf(at_, numbers_);
        rounded.to = placeOf(move.to, numbers_);
        const double du = rounded.to[u] - rounded.from[u], dv = rounded.to[v] - rounded.from[v];
        const double chord = std::hypot(du, dv);
        if (chord > 0.0) {
            const double cu = arc.centre[u] - 0.5 * (rounded.from[u] + rounded.to[u]);
            const double cv = arc.centre[v] - 0.5 * (rounded.from[v] + rounded.to[v]);
            const double along = (cu * du + cv * dv) / chord;
            rounded.centre[u] -= along * du / chord;
            rounded.centre[v] -= along * dv / chord;
        }
        move.offset[axisIndex(u)] = numbers_.stepsOf(rounded.centre[u] - rounded.from[u]);
        move.offset[axisIndex(v)] = numbers_.stepsOf(rounded.centre[v] - rounded.from[v]);
        move.offset = bestOffset(rounded, move.offset);
        rounded.centre = rounded.from + placeOf(move.offset, numbers_);
        const ArcTurn turn = turnOf(rounded), wanted = turnOf(arc);
        if (strayed(arc, rounded) > strayedSteps * numbers_.step() + strayedBeyond ||
            std::abs(turn.startRadius - turn.endRadius) > limits_.largestMismatch - computed ||
            std::min(turn.startRadius, turn.endRadius) < limits_.smallestRadius ||
            std::abs(turn.sweep - wanted.sweep) > sweepTolerance)
            return std::nullopt;
        return move;
    }

    /// Of the rounded centre and its neighbours by one step, the one whose radii agree best; the rounded one if equal.
    StepPlace bestOffset(Arc arc, const StepPlace& rounded) const {
        const int u = (arc.axis + 1) % 3, v = (arc.axis + 2) % 3;
        StepPlace best = rounded;
        double least = std::numeric_limits<double>::infinity();
        for (const auto& [du, dv] :
             {std::pair{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {1, -1}, {-1, 1}, {-1, -1}}) {
            StepPlace offset = rounded;
            offset[axisIndex(u)] += du;
            offset[axisIndex(v)] += dv;
            arc.centre = arc.from + placeOf(offset, numbers_);
            const ArcTurn turn = turnOf(arc);
            const double mismatch = std::abs(turn.startRadius - turn.endRadius);
            if (mismatch >= least - 1e-9) continue;
            least = mismatch;
            best = offset;
            if (least <= limits_.largestMismatch - computed) break;
        }
        return best;
    }

    const NumberWords& numbers_;
    const DialectArcs& limits_;
    StepPlace at_{};
    std::vector<StepMove> moves_;
};

} // namespace

std::vector<StepMove> arcSteps(const Arc& arc, const StepPlace& from, const NumberWords& numbers,
                               const DialectArcs& limits) {
    return ArcWriter(numbers, limits).write(arc, from);
}

} // namespace burin
