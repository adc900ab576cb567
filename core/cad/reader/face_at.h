// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/cad/part_face.h"

#include <TopoDS_Shape.hxx>

namespace burin {

/// See partFaceAt; in the B-rep's frame. Errors: fileDamaged (no face that can be measured).
Result<PartFace> faceAt(const TopoDS_Shape& shape, const glm::dvec3& place);

} // namespace burin
