// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/oracles/system_watch.h"

#include <cstddef>

namespace burin::benchmarks {

/// Counts what must not happen in a tick, on the calling thread: calls of the malloc family (which operator new uses as
/// well) and page faults, minor and major. For many intervals in turn, with the same counting as in tests
/// (SystemWatch).
class TickWatch {
public:
    void begin() noexcept;
    /// Resets the counts.
    void restart() noexcept {
        allocations_ = pageFaults_ = 0;
        counting_ = false;
    }
    void end() noexcept; ///< does nothing without a preceding `begin`
    std::size_t allocations() const noexcept { return allocations_; }
    std::size_t pageFaults() const noexcept { return pageFaults_; }
    /// False under a sanitizer, which needs malloc for itself.
    static bool countsAllocations() noexcept;

private:
    tests::SystemWatch watch_{tests::SystemWatch::Watched::butSystemCalls};
    std::size_t allocations_ = 0, pageFaults_ = 0;
    bool counting_ = false;
};

} // namespace burin::benchmarks
