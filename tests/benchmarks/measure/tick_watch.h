// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace burin::benchmarks {

/// Counts what must not happen in a tick, on the calling thread: calls of the malloc family (operator new ends there
/// too) and page faults, minor and major. The program's own malloc counts, so nothing in any library escapes it.
class TickWatch {
public:
    void begin() noexcept;
    void end() noexcept; ///< without a `begin` nothing
    std::size_t allocations() const noexcept { return allocations_; }
    std::size_t pageFaults() const noexcept { return pageFaults_; }
    /// False under a sanitizer, which needs malloc for itself.
    static bool countsAllocations() noexcept;

private:
    std::size_t allocationsBefore_ = 0, faultsBefore_ = 0, allocations_ = 0, pageFaults_ = 0;
    bool counting_ = false;
};

} // namespace burin::benchmarks
