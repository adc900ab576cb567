// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/geometry/triangle_mesh.h"
#include "core/tool/tool.h"

#include <vector>

namespace burin {

/// A profile that holds what a mesh sweeps when it turns about Z.
struct RevolutionEnvelope {
    std::vector<ProfileElement> profile; ///< from (0, 0), straight lines alone
    double widest = 0.0;                 ///< mm, its largest radius
    double excess = 0.0; ///< mm, by which its radius is at most more than that of what the mesh sweeps; never less
};

/// The least such profile, but for lines that are left out where the others stand at most `tolerance` away from the
/// axis: what is found clear of it is clear of the mesh. A hollow tip is filled, as profiles never fall.
/// @param mesh mm, closed; its lowest vertex at height 0
/// @param tolerance mm, > 0
/// Errors: argumentInvalid (a mesh without height, or with a gap between two heights). Allocates.
Result<RevolutionEnvelope> revolutionEnvelope(const TriangleMesh& mesh, double tolerance);

} // namespace burin
