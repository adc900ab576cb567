// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/verify/obstacles.h"

#include "core/base/parallel.h"
#include "core/path/part_guard.h"

#include <optional>

namespace burin {

Result<void> judgeObstacles(const std::vector<ToolMove>& moves, std::span<const Tool> tools,
                            const VerifyRequest& request, std::span<const std::uint32_t> numbers, KeptDips& kept,
                            Findings& findings, const Progress& progress) {
    std::size_t question = 0;
    for (const ObstacleSolid& obstacle : solidsOf(request.obstacles)) {
        KeptDips::List& known = kept.of(question++);
        if (!obstacle.on) continue;
        std::vector<PartGuard> guards;
        for (const Tool& tool : tools) guards.emplace_back(*obstacle.surface, tool);
        std::vector<std::optional<PartGuard::Dip>> dips(moves.size());
        parallelFor(std::size_t{0}, moves.size(), [&](std::size_t i) {
            const ToolMove& move = moves[i];
            if (progress.cancelled() || !move.endKnown || known.find(numbers[i], dips[i])) return;
            dips[i] = guards[move.tool].deepestDip(move.begin(), move.to, -request.gougeTolerance, request.sampling);
        });
        if (progress.cancelled()) return Error{ErrorCode::cancelled, "verification", {}, {}};
        for (std::size_t i = 0; i < moves.size(); ++i) {
            const ToolMove& move = moves[i];
            if (move.endKnown) known.keep(numbers[i], dips[i]);
            if (!dips[i]) continue;
            const ToolClearance deepest = guards[move.tool].clearance(move.poseAt(dips[i]->part), 1.0);
            findings.add(FindingKind::obstacleCollision, move.line, deepest.meshPoint, -dips[i]->clearance);
        }
    }
    return {};
}

} // namespace burin
