// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/verify/tool_moves.h"

namespace burin {

std::vector<ToolMove> toolMoves(const ParsedProgram& program, const glm::dvec3& workOffset) {
    std::vector<ToolMove> moves;
    moves.reserve(program.motions.size());
    for (const NcMotion& motion : program.motions) {
        ToolMove move;
        move.from = motion.from + workOffset;
        move.to = motion.to + workOffset;
        move.feed = motion.feed;
        move.line = motion.line;
        move.rapid = motion.rapid;
        move.spindleOn = motion.spindleOn;
        move.startKnown = motion.fromKnown[0] && motion.fromKnown[1] && motion.fromKnown[2];
        moves.push_back(move);
    }
    return moves;
}

} // namespace burin
