// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/recording/sample_ranges.h"

#include <algorithm>

namespace burin {

std::vector<SampleRange> joined(std::vector<SampleRange> ranges) {
    std::ranges::sort(ranges, {}, &SampleRange::first);
    std::vector<SampleRange> together;
    for (const SampleRange& range : ranges) {
        if (range.count == 0) continue;
        const std::uint64_t end = range.first + range.count;
        if (together.empty() || range.first > together.back().first + together.back().count)
            together.push_back(range);
        else
            together.back().count = std::max(together.back().count, end - together.back().first);
    }
    return together;
}

std::vector<SampleRange> without(std::span<const SampleRange> ranges, const SampleRange& gone) {
    const std::uint64_t begin = gone.first, end = gone.first + gone.count;
    std::vector<SampleRange> rest;
    const auto add = [&rest](std::uint64_t from, std::uint64_t to) {
        if (from < to) rest.push_back({from, to - from});
    };
    for (const SampleRange& range : ranges) {
        const std::uint64_t to = range.first + range.count;
        add(range.first, std::min(to, begin));
        add(std::max(range.first, end), to);
    }
    return rest;
}

} // namespace burin
