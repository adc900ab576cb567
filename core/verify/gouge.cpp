// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/verify/gouge.h"

#include "core/base/parallel.h"
#include "core/verify/move_samples.h"

#include <algorithm>
#include <atomic>

namespace burin {

namespace {

/// A place along the moves that is near the part.
struct Sample {
    std::uint32_t move = 0;
    glm::dvec3 tip{0.0};
    ToolClearance clearance;
};

/// What a batch of samples found.
struct Batch {
    std::vector<Sample> near;
    std::size_t finishSamples = 0, onPart = 0;
};

/// Judges one batch of samples after another on the mesh.
class MeshJudge {
public:
    MeshJudge(const std::vector<ToolMove>& moves, std::span<const Tool> tools, std::span<const ShrunkOutline> outlines,
              const VerifyRequest& request)
        : moves_(moves), outlines_(outlines), part_(*request.part), cuttingFeed_(tools.size()) {
        for (const Tool& tool : tools) {
            stacks_.push_back(pieces(tool.cutter));
            flutes_.push_back(flutePieces(tool.cutter));
        }
        for (const ToolMove& move : moves) // plunges are slower than the cutting feed
            if (!move.rapid) cuttingFeed_[move.tool] = std::max(cuttingFeed_[move.tool], move.feed);
    }

    Batch judge(const MoveSamples& samples, std::size_t first, std::size_t end) const {
        Batch batch;
        std::optional<ClearanceAsker> asker;
        std::uint16_t tool = 0;
        glm::dvec3 last(0.0);
        double spare = -1.0, within = leastSearch; // mm: from `last`, how far nothing can come near; how far was asked
        samples.forEach(first, end, [&](std::uint32_t number, const glm::dvec3& tip) {
            const ToolMove& move = moves_[number];
            if (!asker || move.tool != tool) {
                asker.emplace(part_, stacks_[move.tool]);
                tool = move.tool;
                spare = -1.0;
            }
            bool onPart = false;
            if (glm::length(tip - last) > spare) {
                const ToolClearance found = asker->ask(tip, within, answers);
                last = tip;
                spare = found.clearance - onPartDistance;
                within = found.clearance < within ? leastSearch : std::min(2.0 * within, greatestSearch);
                onPart = found.clearance <= onPartDistance && isByFlutes(found, tool, tip);
                if (found.clearance <= onPartDistance) batch.near.push_back({number, tip, found});
            }
            if (!isFinishing(move) || !outlines_[tool].contains(tip.x, tip.y)) return;
            ++batch.finishSamples;
            if (onPart) ++batch.onPart;
        });
        return batch;
    }

private:
    /// A gouge is told exactly, what is clear to 1e-4 mm: more than that is neither reported nor ranked.
    static constexpr ClearanceTolerance answers{1e-4, 0.0, 1e-8};
    static constexpr double leastSearch = 0.5, greatestSearch = 8.0; // mm: farther from the part nobody asks how far

    bool isFinishing(const ToolMove& move) const noexcept {
        return !move.rapid && move.startKnown && move.feed >= cuttingFeed_[move.tool];
    }
    bool isByFlutes(const ToolClearance& found, std::uint16_t tool, const glm::dvec3& tip) const {
        if (found.piece < flutes_[tool].size()) return true;
        const ToolPose pose{tip, {0.0, 0.0, 1.0}};
        return part_.clearance(flutes_[tool], pose, 2.0 * onPartDistance).clearance <= onPartDistance;
    }

    const std::vector<ToolMove>& moves_;
    std::span<const ShrunkOutline> outlines_;
    const MeshDistance& part_;
    std::vector<std::vector<RevolvedPiece>> stacks_, flutes_;
    std::vector<double> cuttingFeed_;
};

/// All samples near the part, in the order of the moves, whatever the number of threads: batches are of fixed length.
std::vector<Sample> nearSamples(const MoveSamples& samples, const MeshJudge& judge, GougeJudgement& judgement,
                                Progress& progress) {
    constexpr std::size_t length = 256;
    std::vector<Batch> batches((samples.count() + length - 1) / length);
    std::atomic<std::size_t> done{0};
    parallelFor(std::size_t{0}, batches.size(), [&](std::size_t i) {
        if (progress.cancelled()) return;
        batches[i] = judge.judge(samples, i * length, std::min((i + 1) * length, samples.count()));
        progress.report(static_cast<double>(++done) / static_cast<double>(batches.size()));
    });
    std::vector<Sample> near;
    for (Batch& batch : batches) {
        near.insert(near.end(), batch.near.begin(), batch.near.end());
        judgement.finishSamples += batch.finishSamples;
        judgement.onPart += batch.onPart;
    }
    return near;
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

/// The worst samples on the B-rep; they stand first in `samples` afterwards.
/// @return their depths, mm
Result<std::vector<double>> exactDepths(std::vector<Sample>& samples, const std::vector<ToolMove>& moves,
                                        std::span<const Tool> tools, const VerifyRequest& request, Progress& progress) {
    const bool exact = request.exactSamples > 0 && !request.model->brep.empty();
    const std::size_t count = std::min(exact ? request.exactSamples : 0, samples.size());
    if (count == 0) return std::vector<double>();
    std::nth_element(samples.begin(), samples.begin() + static_cast<std::ptrdiff_t>(count) - 1, samples.end(),
                     [](const Sample& a, const Sample& b) { return a.clearance.clearance < b.clearance.clearance; });
    std::vector<glm::dvec3> points;
    std::vector<double> offsets;
    for (std::size_t i = 0; i < count; ++i) {
        const ExactQuestion question = questionFor(samples[i], tools[moves[samples[i].move].tool].cutter);
        points.push_back(question.point);
        offsets.push_back(question.offset);
    }
    Result<std::vector<double>> distances = exactSignedDistances(request.model->brep, points, request.import, progress);
    if (!distances) return distances;
    for (std::size_t i = 0; i < count; ++i) (*distances)[i] = offsets[i] - (*distances)[i];
    return distances;
}

} // namespace

Result<GougeJudgement> judgeGouges(const std::vector<ToolMove>& moves, std::span<const Tool> tools,
                                   std::span<const ShrunkOutline> outlines, const VerifyRequest& request,
                                   Findings& findings, Progress& progress) {
    const MoveSamples places(moves, request.sampling);
    GougeJudgement judgement;
    judgement.samples = places.count();
    std::vector<Sample> samples = nearSamples(places, {moves, tools, outlines, request}, judgement, progress);
    if (progress.cancelled()) return Error{ErrorCode::cancelled, "verification", {}, {}};
    for (const Sample& sample : samples)
        judgement.maximumMesh = std::max(judgement.maximumMesh, -sample.clearance.clearance);

    const Result<std::vector<double>> exact = exactDepths(samples, moves, tools, request, progress);
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

} // namespace burin
