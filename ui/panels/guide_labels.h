// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/setup/guide.h"
#include "ui/theme/length_unit.h"

#include <QString>

namespace burin {

/// The name of a kind of guide: "Plane", "Step-over", …
QString guideName(GuideKind kind);

/// A guide in one line, for the view: "Plane · Y 12.000 mm". @param zero program zero, mm, setup frame
QString guideLine(const Guide& guide, const glm::dvec3& zero, LengthUnit unit);

/// The setup axis that is closest to a direction: 0 … 2.
int axisOf(const glm::dvec3& direction);
/// "X"
QString axisLetter(int axis);

} // namespace burin
