// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/omission_labels.h"

#include "ui/messages/messages.h"
#include "ui/panels/texts.h"

#include <QCoreApplication>
#include <QStringList>

namespace burin {

namespace {

class OmissionLabels {
    Q_DECLARE_TR_FUNCTIONS(OmissionLabels)
};

QString omissionLine(const Omission& part, const glm::dvec3& zero, LengthUnit unit) {
    const glm::dvec3 from = part.line.front() - zero;
    return OmissionLabels::tr("%1 from X %2, Y %3, Z %4: %5")
        .arg(lengthText(part.length, unit), lengthNumber(from.x, unit), lengthNumber(from.y, unit),
             lengthNumber(from.z, unit), Messages::text(textOf(part.reason)));
}

} // namespace

QString omittedText(const EditReport& report, LengthUnit unit) {
    if (report.omissions.empty()) return {};
    return OmissionLabels::tr("%1 left out").arg(lengthText(lengthOf(report.omissions), unit));
}

QString omissionLines(const EditReport& report, const glm::dvec3& zero, LengthUnit unit) {
    constexpr std::size_t most = 10;
    const std::vector<const Omission*> parts = longestFirst(report.omissions);
    QStringList lines;
    for (std::size_t i = 0; i < parts.size() && i < most; ++i) lines.append(omissionLine(*parts[i], zero, unit));
    if (parts.size() > most) lines.append(OmissionLabels::tr("and %1 more").arg(countText(parts.size() - most)));
    return lines.join(QLatin1Char('\n'));
}

QString omissionNotice(const std::vector<EditReport>& reports, const glm::dvec3& zero, LengthUnit unit) {
    std::vector<Omission> parts;
    for (const EditReport& report : reports)
        parts.insert(parts.end(), report.omissions.begin(), report.omissions.end());
    if (parts.empty()) return {};
    const QString all =
        OmissionLabels::tr("%1 of the path are left out (red in the view).").arg(lengthText(lengthOf(parts), unit));
    return all + QLatin1Char(' ') + omissionLine(*longestFirst(parts).front(), zero, unit);
}

QString unreachedHolesText(std::size_t holes, HoleWork work) {
    const bool one = holes == 1;
    QString text;
    switch (work) {
    case HoleWork::drilling:
        text = one ? OmissionLabels::tr("One hole is not drilled to full depth: the part is in the way, or the drill "
                                        "is too short.")
                   : OmissionLabels::tr("%1 holes are not drilled to full depth: the part is in the way, or the drill "
                                        "is too short.");
        break;
    case HoleWork::internalThreads:
        text = one ? OmissionLabels::tr("One hole was not threaded: it is not drilled deep enough, or the part is in "
                                        "the way. Drill it deeper first.")
                   : OmissionLabels::tr("%1 holes were not threaded: they are not drilled deep enough, or the part is "
                                        "in the way. Drill them deeper first.");
        break;
    case HoleWork::externalThreads:
        text = one ? OmissionLabels::tr("One stud was not threaded: it is not milled to the major diameter, or part "
                                        "or stock around it are in the way of the tool. Mill it first.")
                   : OmissionLabels::tr("%1 studs were not threaded: they are not milled to the major diameter, or "
                                        "part or stock around them are in the way of the tool. Mill them first.");
        break;
    }
    return one ? text : text.arg(countText(holes));
}

} // namespace burin
