// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/mesh_distance.h"
#include "core/verify/move_samples.h"
#include "core/verify/outline.h"
#include "core/verify/verify.h"

#include <cstdint>
#include <span>
#include <vector>

namespace burin {

/// A place along the moves, and how the tool stands to the part there.
struct GougeSample {
    std::uint32_t move = 0;
    glm::dvec3 tip{0.0};
    ToolClearance clearance;
};

/// What looking along all moves has found.
struct NearSamples {
    /// Of the samples within `onPartDistance` of the part: all that are deeper in it than the tolerance, and the
    /// deepest, at least so many as were asked for. In the order of the moves.
    std::vector<GougeSample> worst;
    std::size_t finishSamples = 0, onPart = 0; ///< as GougeJudgement
};

/// Samples the moves against the part's mesh. The middle of each straight interval of samples is asked first. What the
/// worst of the middles leave open is looked at by intervals: where the whole interval certainly keeps farther from the
/// part than they do (ClearanceAsker::keeps), none of its samples matters. The same whatever the number of threads.
/// @param worst  how many of the deepest samples are requested
NearSamples nearSamples(const std::vector<ToolMove>& moves, const MoveSamples& places, std::span<const Tool> tools,
                        std::span<const ShrunkOutline> outlines, const VerifyRequest& request, std::size_t worst,
                        Progress& progress);

} // namespace burin
