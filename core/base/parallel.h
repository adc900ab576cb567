// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#ifdef __SANITIZE_THREAD__
#include <sanitizer/tsan_interface.h>
#endif

namespace burin {

/// Tells the thread sanitizer about the ordering by oneTBB, which is not built for it: everything done before `give` is
/// visible after `take`. Does nothing without the sanitizer.
class SanitizerOrder {
public:
#ifdef __SANITIZE_THREAD__
    void give() noexcept {
        __tsan_release(&token_);
    }
    void take() noexcept {
        __tsan_acquire(&token_);
    }
#else
    void give() noexcept {}
    void take() noexcept {}
#endif

private:
    char token_ = 0;
};

/// Interface of `parallelIntervals` to oneTBB: calls `interval(work, from, to)` for intervals of 0 … count - 1. Only
/// its source file contains code of oneTBB and is not built for the thread sanitizer, so that all other code can be
/// checked.
void runIntervals(std::size_t count, std::size_t grain, void* work,
                  void (*interval)(void* work, std::size_t from, std::size_t to));

/// Calls `body(from, to)` for intervals that together make up first … end - 1, shared among all cores (oneTBB). Returns
/// when all are done and their results are visible. Intervals run concurrently: they must not write the same data.
/// @param grain intervals are not split below this size. An exception of `body` ends the work and is rethrown to the
/// caller.
template <class Index, class Body>
void parallelIntervals(Index first, Index end, std::size_t grain, const Body& body) {
    if (!(first < end)) return;
    struct Work {
        const Body& body;
        Index first;
        SanitizerOrder started, done;
    } work{body, first, {}, {}};
    work.started.give();
    runIntervals(static_cast<std::size_t>(end - first), grain, &work,
                 [](void* shared, std::size_t from, std::size_t to) {
                     Work& mine = *static_cast<Work*>(shared);
                     mine.started.take();
                     mine.body(static_cast<Index>(mine.first + static_cast<Index>(from)),
                               static_cast<Index>(mine.first + static_cast<Index>(to)));
                     mine.done.give();
                 });
    work.done.take();
}

/// Calls `body(i)` for i from first to end - 1. Otherwise as parallelIntervals.
template <class Index, class Body>
void parallelFor(Index first, Index end, const Body& body) {
    parallelIntervals(first, end, 1, [&](Index from, Index to) {
        for (Index i = from; i != to; ++i) body(i);
    });
}

} // namespace burin
