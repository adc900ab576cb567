// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/hand_times.h"

#include "core/path/path_source.h"
#include "ui/panels/texts.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>

namespace burin {

namespace {

class HandTimeTexts {
    Q_DECLARE_TR_FUNCTIONS(HandTimeTexts)
};

const TakeInfo* takeInfoOf(const std::vector<TakeInfo>& takes, std::int64_t id) {
    const auto found = std::ranges::find(takes, id, &TakeInfo::id);
    return found == takes.end() ? nullptr : &*found;
}

bool missedNoTick(const TakeInfo& take) {
    return *take.seconds <= static_cast<double>(take.sampleCount) * take.tickPeriod;
}

QString sourceTextOf(const std::vector<TakeInfo>& takes, std::int64_t id) {
    if (PathSource{id}.isGenerated()) return HandTimeTexts::tr("pass %1").arg(-id);
    const TakeInfo* const take = takeInfoOf(takes, id);
    return take != nullptr ? takeName(take->name) : HandTimeTexts::tr("take %1").arg(id);
}

} // namespace

QString handTimeText(const std::vector<TakeInfo>& takes, const Moment& moment) {
    if (PathSource{moment.source}.isGenerated())
        return HandTimeTexts::tr("move %1").arg(QLocale().toString(static_cast<qlonglong>(moment.tick)));
    const TakeInfo* const take = takeInfoOf(takes, moment.source);
    if (take == nullptr || !take->seconds || take->sampleCount == 0)
        return HandTimeTexts::tr("sample %1").arg(QLocale().toString(static_cast<qlonglong>(moment.tick)));
    if (!missedNoTick(*take)) {
        const double share = static_cast<double>(moment.tick) / static_cast<double>(take->sampleCount);
        return HandTimeTexts::tr("≈ %1 s").arg(QLocale().toString(share * *take->seconds, 'f', 1));
    }
    return HandTimeTexts::tr("%1 s").arg(
        QLocale().toString(static_cast<double>(moment.tick) * take->tickPeriod, 'f', 2));
}

QString momentText(const std::vector<TakeInfo>& takes, const Moment& moment) {
    return HandTimeTexts::tr("%1, %2").arg(sourceTextOf(takes, moment.source), handTimeText(takes, moment));
}

QString stretchText(const std::vector<TakeInfo>& takes, const SourceStretch& stretch) {
    if (stretch.source == 0) return HandTimeTexts::tr("everything");
    const Moment first{stretch.source, stretch.first}, last{stretch.source, stretch.last};
    if (stretch.last == stretch.first) return momentText(takes, first);
    if (stretch.last == SourceStretch{}.last)
        return HandTimeTexts::tr("%1, from %2").arg(sourceTextOf(takes, stretch.source), handTimeText(takes, first));
    return HandTimeTexts::tr("%1, %2 to %3")
        .arg(sourceTextOf(takes, stretch.source), handTimeText(takes, first), handTimeText(takes, last));
}

} // namespace burin
