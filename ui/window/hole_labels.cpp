// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/hole_labels.h"

#include "core/cad/part_holes.h"

namespace burin {

QString holeSizesText(const std::vector<UprightHole>& holes, LengthUnit unit) {
    QStringList sizes;
    for (const HoleSize& size : sizesOf(holes))
        sizes << QStringLiteral("%1 × %2").arg(size.count).arg(lengthText(size.diameter, unit));
    return sizes.join(QStringLiteral(", "));
}

QString holeText(const UprightHole& hole, LengthUnit unit) {
    return HoleLabels::tr("⌀ %1, %2 deep")
        .arg(lengthText(2.0 * hole.radius, unit), lengthText(hole.top - hole.bottom, unit));
}

QString pickedText(const glm::dvec2& place, const std::vector<UprightHole>& holes, LengthUnit unit) {
    const UprightHole* hole = holeAround(holes, place);
    const QString what = hole != nullptr ? holeText(*hole, unit) : HoleLabels::tr("no hole of the part");
    return HoleLabels::tr("%1 at X %2, Y %3").arg(what, lengthText(place.x, unit), lengthText(place.y, unit));
}

} // namespace burin
