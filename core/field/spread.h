// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/parallel.h"
#include "core/base/progress.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>

namespace burin {

/// Spreads `count` pieces of work over the processors, reported from `from` to `to`; what is left is skipped when the
/// work is cancelled. @param work  takes the first and the end of a stretch of numbers  @param length  of a stretch, at
/// most
template <class Work>
void spreadStretches(std::size_t count, double from, double to, Progress& progress, const Work& work,
                     std::size_t length = 16) {
    std::atomic<std::size_t> done{0};
    const std::thread::id caller = std::this_thread::get_id(); // Progress has one writer
    const std::size_t stretches = (count + length - 1) / length;
    parallelFor(std::size_t{0}, stretches, [&](std::size_t stretch) {
        if (progress.cancelled()) return;
        work(stretch * length, std::min(count, (stretch + 1) * length));
        const std::size_t ready = done.fetch_add(1, std::memory_order_relaxed) + 1;
        if (std::this_thread::get_id() == caller)
            progress.report(from + (to - from) * static_cast<double>(ready) / static_cast<double>(stretches));
    });
}

/// The same, one number at a time.
template <class Work>
void spread(std::size_t count, double from, double to, Progress& progress, const Work& work) {
    spreadStretches(count, from, to, progress, [&](std::size_t first, std::size_t end) {
        for (std::size_t i = first; i < end && !progress.cancelled(); ++i) work(i);
    });
}

} // namespace burin
