// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/nc/parsed_program.h"

#include "core/base/units.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

/// On an arc, the other axes move in proportion to its sweep.
AxisValues placeIn(const NcMotion& motion, const ArcTurn& turn, double share) {
    AxisValues place = between(motion.from, motion.to, share);
    place.setLinear(placeOn(motion.arc(), turn, share));
    return place;
}

void appendChords(const NcMotion& motion, double chordTolerance, std::vector<NcMotion>& moves) {
    const ArcTurn turn = motion.turn();
    const double radius = std::max(turn.startRadius, turn.endRadius);
    const double step = 2.0 * std::acos(std::max(0.5, 1.0 - chordTolerance / radius));
    const auto count = static_cast<std::size_t>(std::max(1.0, std::ceil(std::abs(turn.sweep) / step)));
    NcMotion chord = motion;
    chord.kind = NcMotionKind::line;
    for (std::size_t i = 1; i <= count; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(count);
        chord.to = placeIn(motion, turn, share);
        chord.toKnown = motion.toKnown;
        moves.push_back(chord);
        chord.from = chord.to;
        chord.fromKnown = motion.toKnown;
    }
}

} // namespace

ArcTurn NcMotion::turn() const noexcept {
    ArcTurn turn = turnOf(arc());
    turn.sweep += (clockwise ? -2.0 : 2.0) * pi * wholeTurns;
    return turn;
}

double lengthOf(const NcMotion& motion) noexcept {
    return motion.kind == NcMotionKind::arc ? lengthOf(motion.arc(), motion.turn())
                                            : glm::distance(motion.from.linear(), motion.to.linear());
}

double rotationOf(const NcMotion& motion) noexcept {
    double most = 0.0;
    if (motion.from.onlyLinear() && motion.to.onlyLinear()) return most;
    for (const Axis axis : {Axis::a, Axis::b, Axis::c})
        most = std::max(most, std::abs(motion.to[axis] - motion.from[axis]));
    return most;
}

AxisValues placeIn(const NcMotion& motion, double share) {
    return motion.kind == NcMotionKind::arc ? placeIn(motion, motion.turn(), share)
                                            : between(motion.from, motion.to, share);
}

std::vector<NcMotion> straightMoves(const ParsedProgram& program, double chordTolerance) {
    std::vector<NcMotion> moves;
    moves.reserve(program.motions.size());
    for (const NcMotion& motion : program.motions) appendStraightMoves(motion, chordTolerance, moves);
    return moves;
}

void appendStraightMoves(const NcMotion& motion, double chordTolerance, std::vector<NcMotion>& moves) {
    if (motion.kind == NcMotionKind::arc)
        appendChords(motion, chordTolerance, moves);
    else if (motion.kind != NcMotionKind::dwell)
        moves.push_back(motion);
}

} // namespace burin
