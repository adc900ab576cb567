// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/part_measure.h"
#include "ui/theme/length_unit.h"

#include <QString>

namespace burin {

/// The figure that stands beside what was measured in the view: "25.000 mm", "Ø 12.000 mm".
QString mainFigure(const PartMeasure& measure, LengthUnit unit);
/// All of it, in sentences. @param zero mm, setup frame: where positions are counted from
QString measureText(const PartMeasure& measure, const glm::dvec3& zero, LengthUnit unit);

} // namespace burin
