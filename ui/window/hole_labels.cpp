// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/hole_labels.h"

#include "core/cad/part_holes.h"

namespace burin {

std::vector<UprightHole> sideOf(std::vector<UprightHole> walls, bool studs) {
    std::erase_if(walls, [studs](const UprightHole& wall) { return wall.stud != studs; });
    return walls;
}

QString holeSizesText(const std::vector<UprightHole>& holes, LengthUnit unit) {
    QStringList sizes;
    for (const HoleSize& size : sizesOf(holes))
        sizes << QStringLiteral("%1 × %2").arg(size.count).arg(lengthText(size.diameter, unit));
    return sizes.join(QStringLiteral(", "));
}

QString holeText(const UprightHole& hole, LengthUnit unit) {
    return (hole.stud ? HoleLabels::tr("stud ⌀ %1, %2 high") : HoleLabels::tr("⌀ %1, %2 deep"))
        .arg(lengthText(2.0 * hole.radius, unit), lengthText(hole.top - hole.bottom, unit));
}

QString pickedText(const glm::dvec2& place, const std::vector<UprightHole>& holes, LengthUnit unit) {
    const UprightHole* hole = holeAround(holes, place);
    const QString what = hole != nullptr ? holeText(*hole, unit) : HoleLabels::tr("no hole or stud of the part");
    return HoleLabels::tr("%1 at X %2, Y %3").arg(what, lengthText(place.x, unit), lengthText(place.y, unit));
}

} // namespace burin
