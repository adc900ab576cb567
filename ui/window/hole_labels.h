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

/// Those of a list that are studs, or holes.
std::vector<UprightHole> sideOf(std::vector<UprightHole> walls, bool studs);
/// The number of holes, or studs, of each diameter; empty if there are none.
QString holeSizesText(const std::vector<UprightHole>& holes, LengthUnit unit);
/// Diameter and depth of a hole, diameter and height of a stud.
QString holeText(const UprightHole& hole, LengthUnit unit);
/// The hole, or stud, at a point of the setup frame, mm, and the point.
QString pickedText(const glm::dvec2& place, const std::vector<UprightHole>& holes, LengthUnit unit);

} // namespace burin
