// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/verify/replay.h"

#include "core/cutting/contact.h"
#include "core/cutting/removal.h"

#include <cmath>

namespace burin {

namespace {

/// A rapid that grazes what it just cut removes nothing: both use the same lines and the same rounding. What is left to
/// tolerate is one run unit on the lines of a voxel's face.
constexpr double harmlessRemoval = 1e-3; // mm³

void judgeRemoval(const ToolMove& move, const CutResult& cut, Findings& findings) {
    if (cut.volume <= harmlessRemoval) return;
    if (move.rapid) findings.add(FindingKind::rapidInStock, move.line, cut.centroid, cut.volume);
    if (!move.spindleOn) findings.add(FindingKind::spindleOff, move.line, cut.centroid, cut.volume);
}

void judgeContact(const ToolMove& move, const Cutter& cutter, const ShankContact& contact, Findings& findings) {
    if (!contact.touches) return;
    const bool shank = sectionOf(cutter, contact.piece) == ToolSection::shank;
    const FindingKind kind = shank ? FindingKind::shankCollision : FindingKind::holderCollision;
    findings.add(kind, move.line, contact.place, contact.volume);
}

} // namespace

Result<double> replay(const std::vector<ToolMove>& moves, const Tool& tool, RunVolume& workpiece, Findings& findings,
                      Progress& progress) {
    const double step = workpiece.grid().edge();
    const std::vector<RevolvedPiece> stack = pieces(tool.cutter);
    const std::size_t fluteCount = flutePieces(tool.cutter).size();
    ContactCheck contact(workpiece.grid());
    MaterialRemoval removal(tool.cutter, workpiece.grid());
    double removed = 0.0;
    for (std::size_t index = 0; index < moves.size(); ++index) {
        if (index % 256 == 0) {
            if (progress.cancelled()) return Error{ErrorCode::cancelled, "verification", {}, {}};
            progress.report(static_cast<double>(index) / static_cast<double>(moves.size()));
        }
        const ToolMove& move = moves[index];
        const glm::dvec3 from = move.startKnown ? move.from : move.to;
        const int steps = std::max(1, static_cast<int>(std::ceil(glm::length(move.to - from) / step)));
        glm::dvec3 tip = from;
        for (int i = 1; i <= steps; ++i) {
            const glm::dvec3 next = i == steps ? move.to : glm::mix(from, move.to, static_cast<double>(i) / steps);
            const CutResult cut = removal.cut(workpiece, tip, next);
            if (cut.outOfMemory)
                return Error{ErrorCode::volumeOutOfMemory, std::to_string(workpiece.reservedBytes()), {}, {}};
            removed += cut.volume;
            judgeRemoval(move, cut, findings);
            judgeContact(move, tool.cutter, contact.at(workpiece, stack, fluteCount, {next, {0.0, 0.0, 1.0}}), findings);
            tip = next;
        }
    }
    return removed;
}

} // namespace burin
