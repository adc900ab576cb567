// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/guide_labels.h"

#include "ui/panels/quantity.h"
#include "ui/panels/texts.h"

#include <QCoreApplication>

#include <array>

namespace burin {

namespace {

struct GuideLabels {
    Q_DECLARE_TR_FUNCTIONS(GuideLabels)
};

/// The coordinate of a guide along an axis: "Y 12.000 mm"
QString placeOn(int axis, const Guide& guide, const glm::dvec3& zero, LengthUnit unit) {
    return axisLetter(axis) + QLatin1Char(' ') + lengthText(guide.point[axis] - zero[axis], unit);
}

QString figures(const Guide& guide, const glm::dvec3& zero, LengthUnit unit) {
    const int axis = axisOf(guide.direction);
    switch (guide.kind) {
    case GuideKind::plane:
        return placeOn(axis, guide, zero, unit);
    case GuideKind::levels:
        return GuideLabels::tr("%1 apart").arg(shortLength(guide.distance, unit));
    case GuideKind::line:
        return placeOn((axis + 1) % 3, guide, zero, unit) + QStringLiteral(" · ") +
               placeOn((axis + 2) % 3, guide, zero, unit);
    case GuideKind::surface:
    case GuideKind::stepOver:
        return shortLength(guide.distance, unit);
    case GuideKind::axis:
        return quantityText(guide.lead, Quantity::angle, unit) + QStringLiteral(" · ") +
               quantityText(guide.tilt, Quantity::angle, unit);
    case GuideKind::curve:
        break;
    }
    return {};
}

} // namespace

QString guideName(GuideKind kind) {
    switch (kind) {
    case GuideKind::plane:
        return GuideLabels::tr("Plane");
    case GuideKind::levels:
        return GuideLabels::tr("Levels");
    case GuideKind::line:
        return GuideLabels::tr("Line");
    case GuideKind::curve:
        return GuideLabels::tr("Edge of the part");
    case GuideKind::surface:
        return GuideLabels::tr("Distance from the part");
    case GuideKind::stepOver:
        return GuideLabels::tr("Step-over");
    case GuideKind::axis:
        return GuideLabels::tr("Lead and tilt");
    }
    return {};
}

QString guideLine(const Guide& guide, const glm::dvec3& zero, LengthUnit unit) {
    const QString text = figures(guide, zero, unit);
    return text.isEmpty() ? guideName(guide.kind) : guideName(guide.kind) + QStringLiteral(" · ") + text;
}

int axisOf(const glm::dvec3& direction) {
    const glm::dvec3 size = glm::abs(direction);
    if (size.z >= size.x && size.z >= size.y) return 2;
    return size.y >= size.x ? 1 : 0;
}

QString axisLetter(int axis) {
    static constexpr std::array<char, 3> letters{'X', 'Y', 'Z'};
    return QString(QLatin1Char(letters[static_cast<std::size_t>(axis)]));
}

} // namespace burin
