// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/cad/model.h"
#include "core/geometry/plan_region.h"

namespace burin {

/// The face of a model at a place as it is seen from above: what is reached from there without a bend of more than 20
/// degrees, which is what hands and eyes take for one face of a B-rep or of a mesh. Frame of the model, mm. What stands
/// upright or faces down has no area from above and is left out.
/// Errors: argumentInvalid (no face is within 1 mm of the place, or it has no area from above).
/// Cost: all triangles of the body.
Result<PlanRegion> faceArea(const Model& model, const glm::dvec3& place);

} // namespace burin
