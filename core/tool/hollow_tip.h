// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/geometry/plan_region.h"
#include "core/geometry/triangle_mesh.h"
#include "core/tool/tool.h"
#include "core/tool/tool_solid.h"

#include <optional>
#include <span>
#include <vector>

namespace burin {

/// The section of a turning tool with a hollow that its profile can't describe.
struct HollowSection {
    PlanRegion section;  ///< (distance from the axis, height above the tip), mm; within the profile
    double excess = 0.0; ///< mm, largest distance of its points from the swept volume, in the hollow; never smaller
};

/// Returns the section of the volume that a mesh sweeps in a turn about Z, with its hollows; elsewhere it is that of
/// the profile. Empty if the profile describes the volume: hollows that are nowhere wider than `narrowest`, that
/// nothing can enter from outside, or only from above, where shank or holder is, count as filled. Empty also if
/// cancelled.
/// @param mesh closed, welded; its lowest vertex at height 0 @param profile its revolutionEnvelope
/// @param narrowest mm, > 0. Allocates; the cost grows with the number of triangles: some seconds for 100,000.
std::optional<HollowSection> hollowSection(const TriangleMesh& mesh, std::span<const ProfileElement> profile,
                                           double narrowest, const Progress& progress);

/// Returns the solid of a turning tool from its section: the body of revolution as a mesh whose facets lie inside it by
/// `revolvedChord` or less, or more if it had more than ToolSolid::mostTriangles; and the size of its hollow.
ToolSolid turningSolid(PlanRegion section, std::span<const ProfileElement> profile);
inline constexpr double revolvedChord = 5e-4; ///< mm

/// Radius of the opening about the axis at a height, mm; 0 if the axis lies in the tool there.
double boreAt(const ToolSolid& solid, double height);

} // namespace burin
