// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/verify/tool_moves.h"

namespace burin {
namespace {

constexpr double arcChord = 0.001; // mm

} // namespace

std::vector<ToolMove> toolMoves(const ParsedProgram& program, const glm::dvec3& workOffset) {
    const std::vector<NcMotion> motions = straightMoves(program, arcChord);
    std::vector<ToolMove> moves;
    moves.reserve(motions.size());
    for (const NcMotion& motion : motions) {
        ToolMove move;
        move.from = motion.from + workOffset;
        move.to = motion.to + workOffset;
        move.feed = motion.feed;
        move.line = motion.line;
        move.rapid = motion.rapid();
        move.spindleOn = motion.spindleOn();
        move.startKnown = motion.startKnown();
        moves.push_back(move);
    }
    return moves;
}

} // namespace burin
