// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace burin::tests {

/// What a stretch of code asked of others, in the thread that ran it.
struct TickCost {
    std::uint64_t allocations = 0; ///< malloc, calloc, realloc, aligned forms, operator new; releases not counted
    std::uint64_t releases = 0;    ///< free, operator delete of something
    std::uint64_t locks = 0;       ///< mutexes, read-write locks, spin locks, conditions, semaphores: taken or tried
    std::uint64_t systemCalls = 0; ///< that entered the kernel, whichever library made them; not those the vDSO answers
    std::uint64_t pageFaults = 0;  ///< that the kernel answered, with or without the disk
};

/// Counts what the calling thread does between `begin` and `end`. The counting is built into the program that links
/// burin::tick_watch: allocation and locking functions of the C library are replaced by ones that count and pass on,
/// and system calls are caught by the kernel's user dispatch (Linux 5.11, x86-64), which needs no rights. What a
/// library does by its own inlined atomics is no lock and is not seen.
///
/// One thread; one watch at a time in a thread. A system call inside costs some µs while it is watched.
class TickWatch {
public:
    TickWatch();
    ~TickWatch();
    TickWatch(const TickWatch&) = delete;
    TickWatch& operator=(const TickWatch&) = delete;

    /// False: this kernel or this build (sanitizers bring their own malloc and signals) can't count; all stays 0.
    bool counts() const noexcept { return counts_; }
    /// Enters the kernel before the counting begins, never after.
    void begin() noexcept;
    /// Stops counting. @return what there was since `begin`
    TickCost end() noexcept;

private:
    bool counts_ = false;
    std::uint64_t faultsBefore_ = 0;
    TickCost before_;
};

} // namespace burin::tests
