// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/verify/verify.h"

#include "core/verify/excess.h"
#include "core/verify/findings.h"
#include "core/verify/gouge.h"
#include "core/verify/limits.h"
#include "core/verify/obstacles.h"
#include "core/verify/outline.h"
#include "core/verify/replay.h"
#include "core/verify/tool_moves.h"

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

/// A cutter this near to the part is said to lie on it.
constexpr double onPartDistance = 0.1; // mm

bool hasOneTool(const ParsedProgram& program) {
    return std::all_of(program.motions.begin(), program.motions.end(), [&](const NcMotion& motion) {
        return motion.tool == 0 || motion.tool == program.motions.back().tool;
    });
}

/// How much of what is cut over the part's outline, shrunk by the radius, lies on the part.
void judgeFinish(const std::vector<ToolMove>& moves, const VerifyRequest& request, const ShrunkOutline& outline,
                 VerifyReport& report) {
    const std::vector<RevolvedPiece> cutter = flutePieces(request.tool.cutter);
    double cuttingFeed = 0.0; // plunges are slower than the cutting feed
    for (const ToolMove& move : moves)
        if (!move.rapid) cuttingFeed = std::max(cuttingFeed, move.feed);
    std::size_t onPart = 0;
    for (const ToolMove& move : moves) {
        if (move.rapid || !move.startKnown || move.feed < cuttingFeed) continue;
        const int steps = std::max(1, static_cast<int>(std::ceil(glm::length(move.to - move.from) / request.sampling)));
        for (int i = 1; i <= steps; ++i) {
            const glm::dvec3 tip = glm::mix(move.from, move.to, static_cast<double>(i) / steps);
            if (!outline.contains(tip.x, tip.y)) continue;
            ++report.onPartSamples;
            const double clearance =
                request.part->clearance(cutter, ToolPose{tip, {0.0, 0.0, 1.0}}, 2.0 * onPartDistance).clearance;
            if (clearance <= onPartDistance) ++onPart;
        }
    }
    if (report.onPartSamples > 0)
        report.onPartShare = static_cast<double>(onPart) / static_cast<double>(report.onPartSamples);
}

void summariseExcess(VerifyReport& report) {
    std::size_t reachable = 0;
    double sum = 0.0;
    for (const DeviationSample& sample : report.deviations) {
        if (!sample.reachable) continue;
        ++reachable;
        sum += sample.excess;
        report.excessMax = std::max(report.excessMax, sample.excess);
    }
    if (reachable == 0) return;
    report.excessMean = sum / static_cast<double>(reachable);
    report.reachableShare = static_cast<double>(reachable) / static_cast<double>(report.deviations.size());
}

} // namespace

Result<VerifyReport> verify(const VerifyRequest& request, Progress& progress, VolumeSnapshot* machined) {
    if (!hasOneTool(*request.program))
        return Error{ErrorCode::notSupported, "a program with a tool change", "one program a tool", {}};
    progress.stage(0.0, 0.05);
    Result<EmbeddedSetup> embedded = embed(*request.model, request.setup, progress);
    if (!embedded) return std::move(embedded).error();
    RunVolume& workpiece = embedded->workpiece;

    const std::vector<ToolMove> moves = toolMoves(*request.program, request.setup.workOffset);
    Findings findings;
    VerifyReport report;
    judgeLimits(moves, request.program->maximumSpindleSpeed, request.machine, request.travel, findings);
    if (Result<void> judged = judgeObstacles(moves, request, findings, progress); !judged)
        return std::move(judged).error();
    report.machiningSeconds = machiningSeconds(moves, request.machine);
    judgeFinish(moves, request, ShrunkOutline(workpiece, request.tool.cutter.radius()), report);

    progress.stage(0.05, 0.4);
    Result<double> removed = replay(moves, request.tool, workpiece, findings, progress);
    if (!removed) return std::move(removed).error();
    report.removed = *removed;

    progress.stage(0.4, 0.9);
    Result<GougeJudgement> gouges = judgeGouges(moves, request, findings, progress);
    if (!gouges) return std::move(gouges).error();
    report.gougeMax = gouges->maximum;
    report.gougeMaxMesh = gouges->maximumMesh;
    report.samples = gouges->samples;
    report.exactSamples = gouges->exactSamples;

    progress.stage(0.9, 1.0);
    Result<std::vector<DeviationSample>> deviations = measureExcess(workpiece, request, progress);
    if (!deviations) return std::move(deviations).error();
    report.deviations = std::move(*deviations);
    summariseExcess(report);

    report.findings = findings.inProgramOrder();
    if (machined != nullptr) *machined = workpiece.snapshot();
    progress.report(1.0);
    return report;
}

} // namespace burin
