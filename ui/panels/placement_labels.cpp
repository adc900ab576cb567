// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/placement_labels.h"

#include "core/base/units.h"
#include "ui/panels/texts.h"

#include <QCoreApplication>
#include <QLocale>

#include <glm/gtc/quaternion.hpp>

#include <cmath>

namespace burin {

namespace {

/// Translation context of this file.
struct PlacementLabels {
    Q_DECLARE_TR_FUNCTIONS(PlacementLabels)
};

QString numberText(double value, int digits) {
    const double scale = std::pow(10.0, digits);
    return QLocale().toString(std::round(value * scale) / scale + 0.0, 'g', 10);
}

/// A direction as text: "X", "-Z", or its components.
QString axisText(const glm::dvec3& axis) {
    constexpr double same = 1e-9;
    for (int i = 0; i < 3; ++i)
        if (std::abs(std::abs(axis[i]) - 1.0) < same)
            return (axis[i] < 0.0 ? QStringLiteral("-") : QString()) + QLatin1Char("XYZ"[i]);
    return QStringLiteral("(%1; %2; %3)").arg(numberText(axis.x, 4), numberText(axis.y, 4), numberText(axis.z, 4));
}

} // namespace

QString placementText(const Placement& placement, LengthUnit unit) {
    const bool turned = placement.turn != glm::dmat3(1.0), shifted = placement.shift != glm::dvec3(0.0);
    if (!turned && !shifted) return PlacementLabels::tr("As in the file.");
    const double scale = unit == LengthUnit::inch ? 1.0 / millimetresPerInch : 1.0;
    const int digits = unit == LengthUnit::inch ? 5 : 4;
    const QString way =
        QStringLiteral("%1; %2; %3 %4")
            .arg(numberText(placement.shift.x * scale, digits), numberText(placement.shift.y * scale, digits),
                 numberText(placement.shift.z * scale, digits), unitText(unit));
    if (!turned) return PlacementLabels::tr("Moved by %1.").arg(way);
    const glm::dquat turn = glm::quat_cast(placement.turn);
    return PlacementLabels::tr("Rotated by %1° about %2, then moved by %3.")
        .arg(numberText(glm::angle(turn) * 180.0 / pi, 4), axisText(glm::axis(turn)), way);
}

} // namespace burin
