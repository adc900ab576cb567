// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/guide_words.h"

#include "ui/panels/quantity.h"
#include "ui/panels/texts.h"

#include <QCoreApplication>

#include <array>

namespace burin {

namespace {

struct GuideWords {
    Q_DECLARE_TR_FUNCTIONS(GuideWords)
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
        return GuideWords::tr("%1 apart").arg(shortLength(guide.distance, unit));
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
        return GuideWords::tr("Plane");
    case GuideKind::levels:
        return GuideWords::tr("Levels");
    case GuideKind::line:
        return GuideWords::tr("Line");
    case GuideKind::curve:
        return GuideWords::tr("Edge of the part");
    case GuideKind::surface:
        return GuideWords::tr("Distance from the part");
    case GuideKind::stepOver:
        return GuideWords::tr("Step-over");
    case GuideKind::axis:
        return GuideWords::tr("Lead and tilt");
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
