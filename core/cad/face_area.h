// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/cad/model.h"
#include "core/geometry/plan_region.h"

namespace burin {

/// The area of the model's face at a point, seen from above: everything that can be reached from the point without a
/// sharp bend (FaceNeighbours). Frame of the model, mm. Triangles that are vertical or face down have no area from
/// above and are left out.
/// Errors: argumentInvalid (no face lies within 1 mm of the point, or it has no area from above).
/// Cost: linear in the triangles of the body.
Result<PlanRegion> faceArea(const Model& model, const glm::dvec3& place);

} // namespace burin
