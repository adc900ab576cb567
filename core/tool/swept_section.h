// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/geometry/plan_region.h"
#include "core/geometry/triangle_mesh.h"

namespace burin {

/// How much larger `sweptSection` may be than the swept volume, mm.
inline constexpr double sweptSectionExcess = 5e-4;

/// Returns the section of the volume that a mesh sweeps in a turn about Z: the points (distance from the axis, height)
/// that it covers at any angle, mm. Never smaller than that, and larger by at most `sweptSectionExcess`. A circle about
/// the axis meets the mesh if it meets the surface or lies inside: the section is the union of the images of all
/// triangles and of the mesh's own section in one half-plane.
/// @param mesh mm, closed, welded, oriented consistently. Allocates. Incomplete if cancelled.
PlanRegion sweptSection(const TriangleMesh& mesh, const Progress& progress);

} // namespace burin
