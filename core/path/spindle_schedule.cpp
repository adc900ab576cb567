// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/spindle_schedule.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>

namespace burin {
namespace {

using Speeds = std::span<double>;
using Intervals = std::span<const SpindleInterval>;

/// Intervals without material take the speed of the next one in their cut, at the end that of the last one.
void fillAir(Speeds speeds, double otherwise) {
    for (std::size_t i = speeds.size() - 1; i-- > 0;)
        if (std::isinf(speeds[i])) speeds[i] = speeds[i + 1];
    for (std::size_t i = 0; i < speeds.size(); ++i)
        if (std::isinf(speeds[i])) speeds[i] = i > 0 ? speeds[i - 1] : otherwise;
}

/// For each interval, the least of its value and of those that end less than `time` before it begins. The queue holds
/// the candidates for the minimum, in ascending order.
template <class Seconds>
void leastWithin(Speeds values, const Seconds& seconds, double time) {
    struct Past {
        double value, end; ///< s
    };
    std::deque<Past> queue;
    double now = 0.0;
    for (std::size_t i = 0; i < values.size(); now += seconds(i++)) {
        while (!queue.empty() && now - queue.front().end >= time) queue.pop_front();
        const double own = values[i];
        if (!queue.empty()) values[i] = std::min(own, queue.front().value);
        while (!queue.empty() && queue.back().value >= own) queue.pop_back();
        queue.push_back({own, now + seconds(i)});
    }
}

/// Limits each speed to the lowest one that follows within `time`.
void slowDownInTime(Intervals cut, Speeds told, double time) {
    std::ranges::reverse(told);
    leastWithin(
        told, [&](std::size_t i) { return cut[cut.size() - 1 - i].seconds; }, time);
    std::ranges::reverse(told);
}

/// A spindle that slows down gets no intermediate command: it goes at once to the lowest speed that follows within
/// `time`, as a new command may delay its arrival.
void fallAtOnce(Intervals cut, Speeds told, double time) {
    for (std::size_t i = 1; i < told.size(); ++i) {
        if (told[i] >= told[i - 1]) continue;
        std::size_t lowest = i;
        double passed = cut[i].seconds;
        for (std::size_t k = i + 1; k < told.size() && passed < time; passed += cut[k++].seconds)
            if (told[k] < told[lowest]) lowest = k;
        std::fill(told.begin() + static_cast<std::ptrdiff_t>(i), told.begin() + static_cast<std::ptrdiff_t>(lowest),
                  told[lowest]);
    }
}

/// Removes raises of the speed that last for less than `time`. One pass; returns false if there was nothing to do.
bool dropShortRaises(Intervals cut, Speeds told, double time) {
    bool changed = false;
    for (std::size_t begin = 0, end = 0; begin < told.size(); begin = end) {
        double seconds = 0.0;
        for (end = begin; end < told.size() && told[end] == told[begin]; ++end) seconds += cut[end].seconds;
        if (begin == 0 || told[begin - 1] >= told[begin] || seconds >= time) continue;
        double lower = told[begin - 1];
        if (end < told.size() && told[end] < told[begin]) lower = std::max(lower, told[end]);
        std::fill(told.begin() + static_cast<std::ptrdiff_t>(begin), told.begin() + static_cast<std::ptrdiff_t>(end),
                  lower);
        changed = true;
    }
    return changed;
}

/// Calls `use(first, end)` for every cut: a sequence of joined intervals.
template <class Use>
void forEachCut(Intervals intervals, const Use& use) {
    for (std::size_t begin = 0, end = 0; begin < intervals.size(); begin = end) {
        for (end = begin + 1; end < intervals.size() && intervals[end].joined;) ++end;
        use(begin, end);
    }
}

} // namespace

SpindleSpeeds spindleSchedule(Intervals intervals, double startTime) {
    SpindleSpeeds speeds;
    double slowest = std::numeric_limits<double>::infinity();
    for (const SpindleInterval& interval : intervals) {
        speeds.told.push_back(interval.fastest);
        slowest = std::min(slowest, interval.fastest);
    }
    forEachCut(intervals, [&](std::size_t begin, std::size_t end) {
        const Intervals cut = intervals.subspan(begin, end - begin);
        const Speeds told = Speeds(speeds.told).subspan(begin, end - begin);
        fillAir(told, slowest);
        slowDownInTime(cut, told, startTime);
        fallAtOnce(cut, told, startTime);
        while (dropShortRaises(cut, told, startTime)) {
        }
    });
    speeds.sureOf = sureSpeeds(intervals, speeds.told, startTime);
    return speeds;
}

std::vector<double> sureSpeeds(Intervals intervals, std::span<const double> told, double startTime) {
    std::vector<double> sure(told.begin(), told.end());
    forEachCut(intervals, [&](std::size_t begin, std::size_t end) {
        leastWithin(
            Speeds(sure).subspan(begin, end - begin), [&](std::size_t i) { return intervals[begin + i].seconds; },
            startTime);
    });
    return sure;
}

} // namespace burin
