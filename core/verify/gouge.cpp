// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/verify/gouge.h"
#include "core/base/parallel.h"

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

/// Farther than this from the part nobody asks how far.
constexpr double searchDistance = 1.0; // mm

struct Sample {
    std::uint32_t move = 0;
    glm::dvec3 tip{0.0};
    ToolClearance clearance;
};

std::vector<Sample> samplesAlong(const std::vector<ToolMove>& moves, double sampling) {
    std::vector<Sample> samples;
    for (std::size_t index = 0; index < moves.size(); ++index) {
        const ToolMove& move = moves[index];
        const glm::dvec3 from = move.startKnown ? move.from : move.to;
        const int steps = std::max(1, static_cast<int>(std::ceil(glm::length(move.to - from) / sampling)));
        for (int i = index == 0 ? 0 : 1; i <= steps; ++i)
            samples.push_back(
                {static_cast<std::uint32_t>(index), glm::mix(from, move.to, static_cast<double>(i) / steps), {}});
    }
    return samples;
}

bool judgeOnMesh(std::vector<Sample>& samples, const VerifyRequest& request, Progress& progress) {
    const std::vector<RevolvedPiece> stack = pieces(request.tool.cutter);
    std::atomic<std::size_t> done{0};
    parallelStretches(std::size_t{0}, samples.size(), 512, [&](std::size_t from, std::size_t to) {
        if (progress.cancelled()) return;
        for (std::size_t i = from; i != to; ++i)
            samples[i].clearance =
                request.part->clearance(stack, ToolPose{samples[i].tip, {0.0, 0.0, 1.0}}, searchDistance);
        done += to - from;
        progress.report(static_cast<double>(done.load()) / static_cast<double>(samples.size()));
    });
    return !progress.cancelled();
}

/// Where the exact judgement has to measure, and what its answer means: gouge = offset − signed distance.
struct ExactQuestion {
    glm::dvec3 point{0.0};
    double offset = 0.0;
};

ExactQuestion questionFor(const Sample& sample, const Cutter& cutter) {
    // A ball is judged by its centre, wherever it touches. Other shapes are judged at the tool's own point that is
    // nearest to the part or deepest in it.
    if (cutter.type == CutterType::ball && sample.clearance.piece == 0 &&
        sample.clearance.meshPoint.z <= sample.tip.z + cutter.radius())
        return {sample.tip + glm::dvec3(0.0, 0.0, cutter.radius()), cutter.radius()};
    return {sample.clearance.meshPoint + sample.clearance.away * sample.clearance.clearance, 0.0};
}

void report(const Sample& sample, double depth, const std::vector<ToolMove>& moves, const VerifyRequest& request,
            Findings& findings) {
    if (depth > request.gougeTolerance)
        findings.add(FindingKind::gouge, moves[sample.move].line, sample.clearance.meshPoint, depth);
}

} // namespace

Result<GougeJudgement> judgeGouges(const std::vector<ToolMove>& moves, const VerifyRequest& request, Findings& findings,
                                   Progress& progress) {
    std::vector<Sample> samples = samplesAlong(moves, request.sampling);
    GougeJudgement judgement;
    judgement.samples = samples.size();
    if (samples.empty()) return judgement;
    if (!judgeOnMesh(samples, request, progress)) return Error{ErrorCode::cancelled, "verification", {}, {}};

    const bool exact = request.exactSamples > 0 && !request.model->brep.empty();
    const std::size_t worstCount = std::min(exact ? request.exactSamples : 0, samples.size());
    const auto nearer = [](const Sample& a, const Sample& b) { return a.clearance.clearance < b.clearance.clearance; };
    std::nth_element(samples.begin(), samples.begin() + static_cast<std::ptrdiff_t>(worstCount) - (worstCount > 0),
                     samples.end(), nearer);
    for (const Sample& sample : samples)
        judgement.maximumMesh = std::max(judgement.maximumMesh, -sample.clearance.clearance);

    std::vector<glm::dvec3> points;
    std::vector<double> offsets;
    for (std::size_t i = 0; i < worstCount; ++i) {
        const ExactQuestion question = questionFor(samples[i], request.tool.cutter);
        points.push_back(question.point);
        offsets.push_back(question.offset);
    }
    if (!points.empty()) {
        Result<std::vector<double>> distances =
            exactSignedDistances(request.model->brep, points, request.import, progress);
        if (!distances) return std::move(distances).error();
        for (std::size_t i = 0; i < worstCount; ++i) {
            const double depth = offsets[i] - (*distances)[i];
            judgement.maximum = std::max(judgement.maximum, depth);
            report(samples[i], depth, moves, request, findings);
        }
        judgement.exactSamples = worstCount;
    }
    for (std::size_t i = worstCount; i < samples.size(); ++i) {
        const double depth = -samples[i].clearance.clearance;
        judgement.maximum = std::max(judgement.maximum, depth);
        report(samples[i], depth, moves, request, findings);
    }
    return judgement;
}

} // namespace burin
