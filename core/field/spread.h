// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/parallel.h"
#include "core/base/parallel_progress.h"

#include <algorithm>
#include <cstddef>

namespace burin {

/// Distributes `count` pieces of work over the processors and reports progress between `from` and `to`; the remaining
/// pieces are skipped after cancellation. @param work  called with the first number and the end of an interval of
/// numbers  @param length  maximum length of an interval
template <class Work>
void spreadIntervals(std::size_t count, double from, double to, Progress& progress, const Work& work,
                     std::size_t length = 16) {
    const std::size_t intervals = (count + length - 1) / length;
    ParallelProgress done(progress, intervals, from, to);
    parallelFor(std::size_t{0}, intervals, [&](std::size_t interval) {
        if (progress.cancelled()) return;
        work(interval * length, std::min(count, (interval + 1) * length));
        done.add();
    });
}

/// The same, with one number at a time.
template <class Work>
void spread(std::size_t count, double from, double to, Progress& progress, const Work& work) {
    spreadIntervals(count, from, to, progress, [&](std::size_t first, std::size_t end) {
        for (std::size_t i = first; i < end && !progress.cancelled(); ++i) work(i);
    });
}

} // namespace burin
