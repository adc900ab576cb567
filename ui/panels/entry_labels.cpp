// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/entry_labels.h"

#include "ui/panels/texts.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <functional>

namespace burin {

namespace {

class EntryLabels {
    Q_DECLARE_TR_FUNCTIONS(EntryLabels)
};

} // namespace

QString entriesText(const EditReport& report) {
    QStringList parts;
    const auto add = [&](EntryForm form, const QString& text) {
        if (const std::size_t count = countOf(report.entries, form); count > 0)
            parts.append(text.arg(countText(count)));
    };
    add(EntryForm::plunge, EntryLabels::tr("plunges %1"));
    add(EntryForm::ramp, EntryLabels::tr("ramps %1"));
    add(EntryForm::helix, EntryLabels::tr("helices %1"));
    return parts.join(QStringLiteral(" · "));
}

QString plungeLines(const EditReport& report, const glm::dvec3& zero, LengthUnit unit) {
    constexpr std::size_t most = 10;
    std::vector<StrokeEntry> plunges;
    std::ranges::copy_if(report.entries, std::back_inserter(plunges),
                         [](const StrokeEntry& entry) { return entry.form == EntryForm::plunge; });
    std::ranges::stable_sort(plunges, std::ranges::greater(), &StrokeEntry::depth);
    QStringList lines;
    for (std::size_t i = 0; i < plunges.size() && i < most; ++i) {
        const glm::dvec3 at = plunges[i].tip - zero;
        lines.append(EntryLabels::tr("Plunge of %1 to X %2, Y %3, Z %4: no room for a ramp or helix")
                         .arg(lengthText(plunges[i].depth, unit), lengthNumber(at.x, unit), lengthNumber(at.y, unit),
                              lengthNumber(at.z, unit)));
    }
    if (plunges.size() > most) lines.append(EntryLabels::tr("and %1 more").arg(countText(plunges.size() - most)));
    return lines.join(QLatin1Char('\n'));
}

} // namespace burin
