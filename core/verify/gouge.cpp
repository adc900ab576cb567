// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/verify/gouge.h"

#include "core/verify/gouge_samples.h"

#include <algorithm>

namespace burin {

namespace {

/// The point at which the exact judgement has to measure, and how to interpret its result: gouge = offset − signed
/// distance.
struct ExactQuestion {
    glm::dvec3 point{0.0};
    double offset = 0.0;
};

ExactQuestion questionFor(const GougeSample& sample, const Cutter& cutter) {
    // A ball is judged by its centre, wherever it touches. Other shapes are judged at the tool's own point that is
    // nearest to the part or deepest in it.
    const ToolPose& pose = sample.pose;
    if (cutter.type == CutterType::ball && sample.clearance.piece == 0 &&
        glm::dot(sample.clearance.meshPoint - pose.tip, pose.axis) <= cutter.radius())
        return {pose.tip + cutter.radius() * pose.axis, cutter.radius()};
    return {sample.clearance.meshPoint + sample.clearance.away * sample.clearance.clearance, 0.0};
}

/// Number of samples to be judged on the B-rep.
std::size_t exactCount(const VerifyRequest& request) {
    return request.protectedBodies().brep.empty() ? 0 : request.exactSamples;
}

/// Judges the worst samples on the B-rep and moves them to the front of `samples`.
/// @return their depths, mm
Result<std::vector<double>> exactDepths(std::vector<GougeSample>& samples, const std::vector<ToolMove>& moves,
                                        std::span<const Tool> tools, const VerifyRequest& request, KeptDistances& kept,
                                        Progress& progress) {
    const std::size_t count = std::min(exactCount(request), samples.size());
    if (count == 0) return std::vector<double>();
    std::nth_element(
        samples.begin(), samples.begin() + static_cast<std::ptrdiff_t>(count) - 1, samples.end(),
        [](const GougeSample& a, const GougeSample& b) { return a.clearance.clearance < b.clearance.clearance; });
    std::vector<glm::dvec3> points;
    std::vector<double> offsets;
    for (std::size_t i = 0; i < count; ++i) {
        const ExactQuestion question = questionFor(samples[i], tools[moves[samples[i].move].tool].cutter);
        points.push_back(question.point);
        offsets.push_back(question.offset);
    }
    if (points != kept.points) {
        Result<std::vector<double>> distances =
            exactSignedDistances(request.protectedBodies(), points, request.import, progress);
        if (!distances) return distances;
        kept = {std::move(points), std::move(*distances)};
    }
    std::vector<double> depths;
    for (std::size_t i = 0; i < count; ++i) depths.push_back(offsets[i] - kept.distances[i]);
    return depths;
}

} // namespace

Result<GougeJudgement> judgeGouges(const std::vector<ToolMove>& moves, std::span<const Tool> tools,
                                   std::span<const ShrunkOutline> outlines, const VerifyRequest& request,
                                   std::span<const std::uint32_t> numbers, KeptGouges& kept, Findings& findings,
                                   Progress& progress) {
    const MoveSamples places(moves, request.sampling);
    GougeJudgement judgement;
    judgement.samples = places.count();
    // One more than on the B-rep: the deepest of those judged on the mesh only.
    NearSamples near =
        nearSamples(moves, places, tools, outlines, request, exactCount(request) + 1, numbers, kept.samples, progress);
    judgement.finishSamples = near.finishSamples;
    judgement.onPart = near.onPart;
    std::vector<GougeSample>& samples = near.worst;
    if (progress.cancelled()) return Error{ErrorCode::cancelled, "verification", {}, {}};
    for (const GougeSample& sample : samples)
        judgement.maximumMesh = std::max(judgement.maximumMesh, -sample.clearance.clearance);

    const Result<std::vector<double>> exact = exactDepths(samples, moves, tools, request, kept.exact, progress);
    if (!exact) return exact.error();
    judgement.exactSamples = exact->size();
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const double depth = i < exact->size() ? (*exact)[i] : -samples[i].clearance.clearance;
        judgement.maximum = std::max(judgement.maximum, depth);
        if (depth <= request.gougeTolerance) continue;
        judgement.places.push_back({samples[i].clearance.meshPoint, depth});
        findings.add(FindingKind::gouge, moves[samples[i].move].line, samples[i].clearance.meshPoint, depth);
    }
    return judgement;
}

Result<GougeJudgement> judgeGouges(const std::vector<ToolMove>& moves, std::span<const Tool> tools,
                                   std::span<const ShrunkOutline> outlines, const VerifyRequest& request,
                                   Findings& findings, Progress& progress) {
    KeptGouges nothing;
    return judgeGouges(moves, tools, outlines, request, KnownMoves().numbersOf(moves), nothing, findings, progress);
}

} // namespace burin
