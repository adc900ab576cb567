// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/mesh_distance.h"
#include "core/verify/move_samples.h"
#include "core/verify/outline.h"
#include "core/verify/sample_batches.h"
#include "core/verify/verify.h"

#include <cstdint>
#include <memory>
#include <span>
#include <unordered_map>
#include <vector>

namespace burin {

/// A sample along the moves, with the clearance of the tool there.
struct GougeSample {
    std::uint32_t move = 0;
    ToolPose pose;
    ToolClearance clearance;
};

/// The result of sampling all moves.
struct NearSamples {
    /// The samples within `onPartDistance` of the part that matter: all that are deeper in it than the tolerance, and
    /// the deepest ones, at least as many as requested. In the order of the moves.
    std::vector<GougeSample> worst;
    std::size_t finishSamples = 0, onPart = 0; ///< as in GougeJudgement
};

/// A batch of samples, judged.
struct SampleBatch;

/// The batches of samples of one program, for the next one with the same part, tools and tolerance.
struct KeptSamples {
    struct Hash {
        std::size_t operator()(const BatchKey& key) const noexcept;
    };
    std::unordered_map<BatchKey, std::shared_ptr<SampleBatch>, Hash> batches;

    std::size_t bytes() const noexcept;
};

/// Samples the moves against the part's mesh. The middle of each straight interval of samples is examined first. What
/// the worst of the middles do not rule out is examined by intervals: if a whole interval certainly stays farther from
/// the part than they do (ClearanceAsker::keeps), none of its samples matters. The result does not depend on the number
/// of threads, nor on what was kept.
/// @param worst  how many of the deepest samples are requested
/// @param numbers of the moves (KnownMoves)
/// @param kept  of samples with the same part, tools and outlines; gets these in the end
NearSamples nearSamples(const std::vector<ToolMove>& moves, const MoveSamples& places, std::span<const Tool> tools,
                        std::span<const ShrunkOutline> outlines, const VerifyRequest& request, std::size_t worst,
                        std::span<const std::uint32_t> numbers, KeptSamples& kept, Progress& progress);

} // namespace burin
