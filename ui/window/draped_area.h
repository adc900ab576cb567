// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/mesh_distance.h"
#include "core/geometry/plan_region.h"
#include "ui/scene/place_chains.h"

namespace burin {

/// The outlines of an area in plan projected onto a part from above; next to the part at the height of its lowest
/// point.
PlaceChains drapedOutlines(const PlanRegion& area, const MeshDistance& part);
/// The same with hatching.
PlaceChains drapedArea(const PlanRegion& area, const MeshDistance& part);

} // namespace burin
