// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/benchmarks/measure/session.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <ctime>
#include <limits>
#include <vector>

namespace burin::benchmarks {

using Clock = std::chrono::steady_clock;

inline double microseconds(Clock::duration time) noexcept {
    return std::chrono::duration<double, std::micro>(time).count();
}
inline double milliseconds(Clock::duration time) noexcept {
    return 1e-3 * microseconds(time);
}
inline double seconds(Clock::duration time) noexcept {
    return 1e-6 * microseconds(time);
}

/// Processor time that the calling thread has used: time of other programs on the same processor does not count.
inline double processorMicroseconds() noexcept {
    std::timespec now{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec);
}

/// Percentile by nearest rank: the least value for which at least `share` of all values are not above it.
inline double percentile(std::vector<double> values, double share) {
    if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
    const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size())));
    const auto place = values.begin() + static_cast<std::ptrdiff_t>(std::max<std::size_t>(rank, 1) - 1);
    std::nth_element(values.begin(), place, values.end());
    return *place;
}

/// How often a path is replayed: at least so many times, and more often while little time has passed.
struct ReplayRule {
    int least = 5;
    int most = 12;
    double enough = 0.8; ///< s: after this time no further replay is started
};

/// Intrinsic times of ticks, µs: the same path is replayed from the same state, and the least time of each tick is
/// kept, which eliminates the time that other programs take on a shared machine.
/// @param restart  restores the start state, not timed
/// @param tick     work of tick i
/// @param between  work of others after it, not timed
/// Throws Cancelled.
template <class Restart, class Tick, class Between>
std::vector<double> leastOfReplays(std::size_t ticks, const Restart& restart, const Tick& tick, const Between& between,
                                   const ReplayRule& rule) {
    std::vector<double> least(ticks, std::numeric_limits<double>::infinity());
    const Clock::time_point begun = Clock::now();
    for (int replay = 0; replay < rule.most; ++replay) {
        if (replay >= rule.least && seconds(Clock::now() - begun) > rule.enough) break;
        restart();
        for (std::size_t i = 0; i < ticks; ++i) {
            const Clock::time_point start = Clock::now();
            tick(i);
            least[i] = std::min(least[i], microseconds(Clock::now() - start));
            between();
            if (Session::cancelled()) throw Cancelled();
        }
    }
    return least;
}
template <class Restart, class Tick>
std::vector<double> leastOfReplays(std::size_t ticks, const Restart& restart, const Tick& tick,
                                   const ReplayRule& rule = {}) {
    return leastOfReplays(
        ticks, restart, tick, [] {}, rule);
}

/// The least time of several runs of a longer work, s.
/// @param prepare  not timed
template <class Prepare, class Work>
double leastSeconds(int runs, const Prepare& prepare, const Work& work) {
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < runs; ++i) {
        Session::throwIfCancelled();
        prepare();
        const Clock::time_point start = Clock::now();
        work();
        least = std::min(least, seconds(Clock::now() - start));
    }
    return least;
}
template <class Work>
double leastSeconds(int runs, const Work& work) {
    return leastSeconds(
        runs, [] {}, work);
}

} // namespace burin::benchmarks
