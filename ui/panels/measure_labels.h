// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/workpiece_measure.h"
#include "ui/theme/length_unit.h"

#include <QString>

namespace burin {

/// Returns a short description of a face: "Plane", "Cylinder, Ø 12.000 mm". @param radius mm, as PartFacePatch has it
QString kindText(MeasuredFace::Kind kind, double radius, LengthUnit unit);
/// The value shown next to a measurement in the view: "25.000 mm", "Ø 12.000 mm".
QString mainFigure(const PartMeasure& measure, LengthUnit unit);
QString mainFigure(const WorkpieceMeasure& measure, LengthUnit unit); ///< "9.968 ± 0.500 mm", "Ø 9.968 ± 0.500 mm"
/// The full measurement, in sentences. @param zero mm, setup frame: the origin of displayed positions
QString measureText(const PartMeasure& measure, const glm::dvec3& zero, LengthUnit unit);
QString measureText(const WorkpieceMeasure& measure, const glm::dvec3& zero, LengthUnit unit);

} // namespace burin
