// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/cad/part_face.h"
#include "core/geometry/placement.h"

namespace burin {

/// Returns the rotation of a part that makes one of its faces point along a direction: a plane by its outward normal, a
/// cylinder or cone by its axis, which is made parallel or antiparallel to the direction, whichever needs the smaller
/// rotation.
/// @param through mm: the fixed point of the rotation. Errors: argumentInvalid (a face of another kind).
Result<Placement> alignedFace(const PartFace& face, const glm::dvec3& direction, const glm::dvec3& through);

} // namespace burin
