// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/geometry/triangle_mesh.h"
#include "core/tool/tool.h"

#include <vector>

namespace burin {

/// A profile that encloses the volume swept by a mesh rotating about Z.
struct RevolutionEnvelope {
    std::vector<ProfileElement> profile; ///< from (0, 0), only straight lines
    double widest = 0.0;                 ///< mm, its largest radius
    double excess = 0.0;                 ///< mm, largest excess of its radius over the swept volume; never smaller
};

/// Returns the smallest such profile, simplified by leaving out lines as long as the others are at most `tolerance`
/// farther from the axis: anything clear of it is clear of the mesh. A hollow tip is filled, as the heights of a
/// profile never decrease (see hollow_tip.h).
/// @param mesh mm, closed; its lowest vertex at height 0
/// @param tolerance mm, > 0
/// Errors: argumentInvalid (a mesh without height, or with a gap between two heights). Allocates.
Result<RevolutionEnvelope> revolutionEnvelope(const TriangleMesh& mesh, double tolerance);

} // namespace burin
