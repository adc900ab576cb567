// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/parallel.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

namespace burin {

void runIntervals(std::size_t count, std::size_t grain, void* work,
                  void (*interval)(void* work, std::size_t from, std::size_t to)) {
    using Range = oneapi::tbb::blocked_range<std::size_t>;
    oneapi::tbb::parallel_for(Range(0, count, grain),
                              [=](const Range& range) { interval(work, range.begin(), range.end()); });
}

} // namespace burin
