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

class HandTimeLabels {
    Q_DECLARE_TR_FUNCTIONS(HandTimeLabels)
};

const TakeInfo* takeInfoOf(const std::vector<TakeInfo>& takes, std::int64_t id) {
    const auto found = std::ranges::find(takes, id, &TakeInfo::id);
    return found == takes.end() ? nullptr : &*found;
}

bool missedNoTick(const TakeInfo& take) {
    return *take.seconds <= static_cast<double>(take.sampleCount) * take.tickPeriod;
}

QString sourceTextOf(const std::vector<TakeInfo>& takes, std::int64_t id) {
    if (PathSource{id}.isGenerated()) return HandTimeLabels::tr("pass %1").arg(-id);
    const TakeInfo* const take = takeInfoOf(takes, id);
    return take != nullptr ? takeName(take->name) : HandTimeLabels::tr("take %1").arg(id);
}

} // namespace

QString handTimeText(const std::vector<TakeInfo>& takes, const Moment& moment) {
    if (PathSource{moment.source}.isGenerated())
        return HandTimeLabels::tr("move %1").arg(QLocale().toString(static_cast<qlonglong>(moment.tick)));
    const TakeInfo* const take = takeInfoOf(takes, moment.source);
    if (take == nullptr || !take->seconds || take->sampleCount == 0)
        return HandTimeLabels::tr("sample %1").arg(QLocale().toString(static_cast<qlonglong>(moment.tick)));
    if (!missedNoTick(*take)) {
        const double share = static_cast<double>(moment.tick) / static_cast<double>(take->sampleCount);
        return HandTimeLabels::tr("≈ %1 s").arg(QLocale().toString(share * *take->seconds, 'f', 1));
    }
    return HandTimeLabels::tr("%1 s").arg(
        QLocale().toString(static_cast<double>(moment.tick) * take->tickPeriod, 'f', 2));
}

QString momentText(const std::vector<TakeInfo>& takes, const Moment& moment) {
    return HandTimeLabels::tr("%1, %2").arg(sourceTextOf(takes, moment.source), handTimeText(takes, moment));
}

QString intervalText(const std::vector<TakeInfo>& takes, const SourceInterval& interval) {
    if (interval.source == 0) return HandTimeLabels::tr("everything");
    const Moment first{interval.source, interval.first}, last{interval.source, interval.last};
    if (interval.last == interval.first) return momentText(takes, first);
    if (interval.last == SourceInterval{}.last)
        return HandTimeLabels::tr("%1, from %2").arg(sourceTextOf(takes, interval.source), handTimeText(takes, first));
    return HandTimeLabels::tr("%1, %2 to %3")
        .arg(sourceTextOf(takes, interval.source), handTimeText(takes, first), handTimeText(takes, last));
}

} // namespace burin
