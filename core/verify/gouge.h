// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/verify/findings.h"
#include "core/verify/tool_moves.h"

namespace burin {

/// How near the tool comes to the part along its moves.
struct GougeJudgement {
    double maximumMesh = 0.0; ///< mm, >= 0, on the mesh
    double maximum = 0.0;     ///< mm, >= 0, exact where the sample was judged exactly
    std::size_t samples = 0;
    std::size_t exactSamples = 0;
};

/// Samples every move, rapids too, at `request.sampling`; on the mesh first, then the worst of them on the B-rep.
/// Errors: those of exactSignedDistances, cancelled.
Result<GougeJudgement> judgeGouges(const std::vector<ToolMove>& moves, const VerifyRequest& request, Findings& findings,
                                   Progress& progress);

} // namespace burin
