// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/cad/part_face.h"
#include "core/geometry/placement.h"

namespace burin {

/// How a part is turned for one of its faces to look along a direction: a plane by its outward normal, a cylinder or
/// cone by its axis, which lies along the direction or against it, whichever is the shorter turn.
/// @param through mm: what stays where it is. Errors: argumentInvalid (a face that is neither).
Result<Placement> alignedFace(const PartFace& face, const glm::dvec3& direction, const glm::dvec3& through);

} // namespace burin
