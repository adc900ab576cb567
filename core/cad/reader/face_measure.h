// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/cad/part_measure.h"

#include <span>

class TopoDS_Face;
class TopoDS_Shape;
class gp_Pnt;

namespace burin {

/// Sets kind, axis, radius and taper of a face.
/// @param on mm, a point of the face, at which the radius of a cone is measured
void describeShape(MeasuredFace& face, const TopoDS_Face& shape, const gp_Pnt& on);

/// Measures the faces that are nearest to one or two points, mm, in the shape's frame. Errors: fileDamaged.
Result<PartMeasure> faceMeasure(const TopoDS_Shape& shape, std::span<const glm::dvec3> places);

} // namespace burin
