// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/verify/findings.h"
#include "core/verify/outline.h"
#include "core/verify/tool_moves.h"

#include <span>

namespace burin {

/// A place of the part that the tool goes into.
struct GougePlace {
    glm::dvec3 place{0.0}; ///< on the part, mm, setup frame
    double depth = 0.0;    ///< mm, > 0
};

/// How near the tool comes to the part along its moves.
struct GougeJudgement {
    double maximumMesh = 0.0; ///< mm, >= 0, on the mesh
    double maximum = 0.0;     ///< mm, >= 0, exact where the sample was judged exactly
    std::size_t samples = 0;  ///< places along the moves: looked at, or too far away by the way from one that was
    std::size_t exactSamples = 0;
    std::size_t finishSamples = 0;  ///< of them those at the tool's highest feed over the part's shrunk outline
    std::size_t onPart = 0;         ///< of those, how many have the flutes within `onPartDistance` of the part
    std::vector<GougePlace> places; ///< of every sample deeper in the part than the tolerance
};

/// A cutter this near to the part is said to lie on it, mm.
inline constexpr double onPartDistance = 0.1;

/// Samples every move, rapids too, at `request.sampling`; on the mesh first, then the worst of them on the B-rep.
/// Samples that the clearance of one before rules out (it changes by no more than the way) are not looked at: they are
/// farther away than `onPartDistance`.
/// @param tools    those that ToolMove::tool counts
/// @param outlines by tool: the part's, shrunk by the tool's radius
/// Errors: those of exactSignedDistances, cancelled.
Result<GougeJudgement> judgeGouges(const std::vector<ToolMove>& moves, std::span<const Tool> tools,
                                   std::span<const ShrunkOutline> outlines, const VerifyRequest& request,
                                   Findings& findings, Progress& progress);

} // namespace burin
