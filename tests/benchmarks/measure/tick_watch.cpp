// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/measure/tick_watch.h"

namespace burin::benchmarks {

bool TickWatch::countsAllocations() noexcept {
    return tests::SystemWatch(tests::SystemWatch::Watched::butSystemCalls).counts();
}

void TickWatch::begin() noexcept {
    counting_ = true;
    watch_.begin();
}

void TickWatch::end() noexcept {
    if (!counting_) return;
    counting_ = false;
    const tests::SystemUse use = watch_.end();
    allocations_ += use.allocations + use.releases; // releasing takes as long
    pageFaults_ += use.pageFaults;
}

} // namespace burin::benchmarks
