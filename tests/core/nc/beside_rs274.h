// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/nc/parser.h"
#include "tests/oracles/canonical_program.h"

#include <QString>

#include <cmath>

// A program as Burin reads it for LinuxCNC is compared with the output of rs274.
namespace burin::beside_rs274 {

inline constexpr double printed = 1e-4; // rs274 prints four decimals
inline constexpr double slowest = 0.1;  // unit/min: LinuxCNC's lower limit for inverse time

/// The machine that rs274 simulates: it is at 0, and all of its offsets are 0.
inline MachineState standing() {
    MachineState state;
    const PartialPlace zero{0.0, 0.0, 0.0};
    state.place = zero;
    for (const int offset : {54, 55, 56, 57, 58, 59, 591, 592, 593}) state.workOffsets[offset] = zero;
    for (int tool = 1; tool <= 7; ++tool) state.lengthOffsets[tool] = 0.0;
    state.lengthOffset = 0.0;
    state.homes = {zero, zero};
    state.unit = 25.4;
    state.unsetParametersAreZero = true;
    return state;
}

inline Result<ParsedProgram> parsed(const std::string& text) {
    return parseProgram(text, "job", defaultControl(), standing());
}

inline CanonicalKind kindOf(NcMotionKind kind) {
    return kind == NcMotionKind::rapid  ? CanonicalKind::rapid
           : kind == NcMotionKind::line ? CanonicalKind::line
           : kind == NcMotionKind::arc  ? CanonicalKind::arc
                                        : CanonicalKind::dwell;
}

inline bool near(const glm::dvec3& a, const glm::dvec3& b, double doubt) {
    return glm::all(glm::lessThanEqual(glm::abs(a - b), glm::dvec3(doubt)));
}

inline QString describe(const glm::dvec3& v) {
    return QString("%1 %2 %3").arg(v.x, 0, 'f', 5).arg(v.y, 0, 'f', 5).arg(v.z, 0, 'f', 5);
}

/// The first difference; empty if there is none. Moves are compared in the unit in which rs274 prints them.
inline QString difference(const CanonicalProgram& truth, const ParsedProgram& program) {
    for (std::size_t i = 0; i < std::min(truth.moves.size(), program.motions.size()); ++i) {
        const CanonicalMove& theirs = truth.moves[i];
        const NcMotion& ours = program.motions[i];
        const QString where = QString("move %1, line %2: ").arg(i).arg(ours.line);
        if (theirs.kind != kindOf(ours.kind)) return where + "kind";
        if (theirs.kind != CanonicalKind::dwell && !near(theirs.to, ours.to.linear() / theirs.unit, theirs.doubt))
            return where + describe(theirs.to) + " against " + describe(ours.to.linear() / theirs.unit);
        if (theirs.kind == CanonicalKind::dwell && std::abs(theirs.seconds - ours.seconds) > printed)
            return where + "seconds";
        if ((theirs.kind == CanonicalKind::line || theirs.kind == CanonicalKind::arc) &&
            ours.feedMode != FeedMode::perRevolution && theirs.feed > slowest * theirs.unit &&
            std::abs(theirs.feed - ours.feed) > printed * std::max(25.4, theirs.feed))
            return where + QString("feed %1 against %2").arg(theirs.feed).arg(ours.feed);
        if (theirs.kind != CanonicalKind::arc) continue;
        glm::dvec3 centre = ours.centre / theirs.unit;
        centre[ours.arcAxis] = 0.0;
        const int turns = static_cast<int>(ours.wholeTurns + 1) * (ours.clockwise ? -1 : 1);
        if (theirs.axis != ours.arcAxis || theirs.turns != turns || !near(theirs.centre, centre, theirs.doubt))
            return where + "arc " + describe(theirs.centre) + " against " + describe(centre);
    }
    return truth.moves.size() == program.motions.size()
               ? QString()
               : QString("%1 moves against %2").arg(truth.moves.size()).arg(program.motions.size());
}

} // namespace burin::beside_rs274
