// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/switched_off.h"

#include "core/recording/sample_ranges.h"

#include <algorithm>
#include <string>
#include <utility>

namespace burin {

Result<SwitchedOff> switchedOff(const Project& project, const SwitchedOff& of) {
    SwitchedOff now;
    for (const auto& [take, ranges] : of) {
        Result<std::vector<SampleRange>> off = project.switchedOff(take);
        if (!off) return std::move(off).error();
        now[take] = std::move(*off);
    }
    return now;
}

Result<SwitchedOff> withInterval(const Project& project, std::int64_t take, const SampleRange& interval, bool off) {
    const Result<TakeOutline> outline = project.takeOutline(take);
    if (!outline) return outline.error();
    const std::uint64_t all = outline->info.sampleCount;
    if (interval.first >= all || interval.count == 0)
        return Error{ErrorCode::argumentInvalid, "stretch", std::to_string(interval.first),
                     "samples of take " + std::to_string(take) + ", which has " + std::to_string(all)};
    Result<std::vector<SampleRange>> now = project.switchedOff(take);
    if (!now) return std::move(now).error();
    const SampleRange within{interval.first, std::min(interval.count, all - interval.first)};
    if (!off) return SwitchedOff{{take, without(*now, within)}};
    now->push_back(within);
    return SwitchedOff{{take, joined(std::move(*now))}};
}

Result<SwitchedOff> offAfter(const Project& project, const TakeMoment& moment) {
    const Result<std::vector<TakeInfo>> takes = project.takes();
    if (!takes) return takes.error();
    const Result<TakeOrder> order = project.takeOrder();
    if (!order) return order.error();
    SwitchedOff off;
    for (const TakeInfo& info : *takes) {
        const std::uint64_t first = info.id == moment.take ? moment.samples : 0;
        if (order->placeOf(info.id) < order->placeOf(moment.take) || first >= info.sampleCount) continue;
        Result<SwitchedOff> one = withInterval(project, info.id, {first, info.sampleCount - first}, true);
        if (!one) return one;
        off.merge(*one);
    }
    return off;
}

Result<void> setSwitchedOff(Project& project, const SwitchedOff& off) {
    for (const auto& [take, ranges] : off)
        if (Result<void> done = project.setSwitchedOff(take, ranges); !done) return done;
    return {};
}

} // namespace burin
