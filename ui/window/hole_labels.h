// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/upright_holes.h"
#include "ui/theme/length_unit.h"

#include <QCoreApplication>

#include <vector>

namespace burin {

/// Translation context of this file.
class HoleLabels {
    Q_DECLARE_TR_FUNCTIONS(HoleLabels)
};

/// The number of holes of each diameter; empty if there are none.
QString holeSizesText(const std::vector<UprightHole>& holes, LengthUnit unit);
/// Diameter and depth of a hole.
QString holeText(const UprightHole& hole, LengthUnit unit);
/// The hole at a point of the setup frame, mm, and the point.
QString pickedText(const glm::dvec2& place, const std::vector<UprightHole>& holes, LengthUnit unit);

} // namespace burin
