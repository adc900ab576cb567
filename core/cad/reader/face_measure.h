// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/cad/part_measure.h"

#include <span>

class TopoDS_Shape;

namespace burin {

/// Measures the faces that are nearest to one or two points, mm, in the shape's frame. Errors: fileDamaged.
Result<PartMeasure> faceMeasure(const TopoDS_Shape& shape, std::span<const glm::dvec3> places);

} // namespace burin
