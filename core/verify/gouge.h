// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/verify/findings.h"
#include "core/verify/gouge_samples.h"
#include "core/verify/outline.h"
#include "core/verify/tool_moves.h"

#include <cstdint>
#include <span>
#include <vector>

namespace burin {

/// A point of the part that the tool enters.
struct GougePlace {
    glm::dvec3 place{0.0}; ///< on the part, mm, setup frame
    double depth = 0.0;    ///< mm, > 0
};

/// The clearance of the tool from the part along its moves.
struct GougeJudgement {
    double maximumMesh = 0.0; ///< mm, >= 0, on the mesh
    double maximum = 0.0;     ///< mm, >= 0, exact where the sample was judged on the B-rep
    /// number of samples along the moves: examined, or ruled out by the clearance at an examined one
    std::size_t samples = 0;
    std::size_t exactSamples = 0;
    std::size_t finishSamples = 0;  ///< samples at the tool's highest feed over the part's shrunk outline
    std::size_t onPart = 0;         ///< of these, those with the flutes within `onPartDistance` of the part
    std::vector<GougePlace> places; ///< one for every sample deeper in the part than the tolerance
};

/// A cutter this close to the part counts as touching it, mm.
inline constexpr double onPartDistance = 0.1;

/// Distances from the B-rep, and the points for which they were asked: the same points in the same order have the same.
struct KeptDistances {
    std::vector<glm::dvec3> points; ///< mm, setup frame
    std::vector<double> distances;  ///< mm
};

/// What a judgement keeps for the next one with the same part and tools.
struct KeptGouges {
    KeptSamples samples;
    KeptDistances exact;
};

/// Samples every move, rapids too, at `request.sampling`: all on the mesh, then the worst of them on the B-rep. Samples
/// that the clearance at an earlier one rules out (the clearance changes by no more than the tool moves) are not
/// examined: they are farther from the part than `onPartDistance`.
/// @param tools    indexed by ToolMove::tool
/// @param outlines by tool: the outline of the part, shrunk by the radius of the tool
/// @param numbers of the moves (KnownMoves) @param kept of judgements with the same part, tools and outlines; the
/// result does not depend on it
/// Errors: those of exactSignedDistances, cancelled.
Result<GougeJudgement> judgeGouges(const std::vector<ToolMove>& moves, std::span<const Tool> tools,
                                   std::span<const ShrunkOutline> outlines, const VerifyRequest& request,
                                   std::span<const std::uint32_t> numbers, KeptGouges& kept, Findings& findings,
                                   Progress& progress);
/// The same, judged for the first time.
Result<GougeJudgement> judgeGouges(const std::vector<ToolMove>& moves, std::span<const Tool> tools,
                                   std::span<const ShrunkOutline> outlines, const VerifyRequest& request,
                                   Findings& findings, Progress& progress);

} // namespace burin
