// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/take_moment_argument.h"

#include "app/number_list.h"
#include "core/base/numbers.h"

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

/// The nearest sample; the end for times beyond it.
std::uint64_t sampleAt(const TakeInfo& take, double seconds) {
    const double samples = std::round(std::max(0.0, seconds) / take.tickPeriod);
    return samples >= static_cast<double>(take.sampleCount) ? take.sampleCount : static_cast<std::uint64_t>(samples);
}

} // namespace

Result<TakeMoment> momentOf(const Project& project, const std::string& text) {
    const std::vector<std::string> parts = partsOf(text, ':');
    const auto take = numbersOf(parts.front(), 1);
    const auto seconds = parts.size() == 2 ? numbersOf(parts.back(), 1) : std::nullopt;
    const bool whole =
        take && take->front() >= 1.0 && take->front() < 1e15 && std::floor(take->front()) == take->front();
    if (!whole || parts.size() > 2 || (parts.size() == 2 && (!seconds || !(seconds->front() >= 0.0))))
        return Error{ErrorCode::argumentInvalid, "moment", text, "TAKE or TAKE:SECONDS"};
    const Result<TakeOutline> outline = project.takeOutline(static_cast<std::int64_t>(take->front()));
    if (!outline) return outline.error();
    const TakeInfo& info = outline->info;
    if (!seconds) return TakeMoment{info.id, info.sampleCount};
    const double end = static_cast<double>(info.sampleCount) * info.tickPeriod;
    if (seconds->front() > end)
        return Error{ErrorCode::argumentInvalid, "moment", text, "0 … " + formatFixed(end, 3) + " s"};
    return TakeMoment{info.id, sampleAt(info, seconds->front())};
}

Result<SampleRange> intervalOf(const Project& project, std::int64_t take, std::optional<double> from,
                               std::optional<double> to) {
    const Result<TakeOutline> outline = project.takeOutline(take);
    if (!outline) return outline.error();
    const std::uint64_t first = sampleAt(outline->info, from.value_or(0.0));
    const std::uint64_t end = to ? sampleAt(outline->info, *to) : outline->info.sampleCount;
    if (first < end) return SampleRange{first, end - first};
    const double all = static_cast<double>(outline->info.sampleCount) * outline->info.tickPeriod;
    return Error{ErrorCode::argumentInvalid, "stretch",
                 formatShortest(from.value_or(0.0)) + " … " + formatShortest(to.value_or(all)) + " s",
                 "0 … " + formatFixed(all, 3) + " s"};
}

} // namespace burin
