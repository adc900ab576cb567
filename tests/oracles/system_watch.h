// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace burin::tests {

/// Calls to the C library and the kernel made by a section of code, in the thread that ran it.
struct SystemUse {
    std::uint64_t allocations = 0; ///< malloc, calloc, realloc, aligned forms, operator new; releases not counted
    std::uint64_t releases = 0;    ///< free and operator delete, except of null pointers
    std::uint64_t locks = 0;       ///< mutexes, read-write locks, spin locks, conditions, semaphores: acquired or tried
    std::uint64_t systemCalls = 0; ///< that entered the kernel, whichever library made them; not those of the vDSO
    std::uint64_t pageFaults = 0;  ///< that the kernel handled, with or without the disk
};

/// Counts the calls of the calling thread between `begin` and `end`. The counting is built into each program that links
/// burin::system_watch: allocation and locking functions of the C library are replaced by ones that count and forward
/// the call, and system calls are caught by the kernel's user dispatch (Linux 5.11, x86-64), which needs no privileges.
/// Inlined atomic operations of a library are no locks and are not seen.
///
/// For one thread; one watch at a time per thread. Each system call takes some µs longer while it is watched.
class SystemWatch {
public:
    enum class Watched : std::uint8_t {
        everything,
        butSystemCalls, ///< for code that is also timed: catching a call takes longer than many calls
    };
    explicit SystemWatch(Watched watched = Watched::everything);
    ~SystemWatch();
    SystemWatch(const SystemWatch&) = delete;
    SystemWatch& operator=(const SystemWatch&) = delete;

    /// False if this kernel or this build (sanitizers bring their own malloc and signals) cannot count; all counts then
    /// stay 0.
    bool counts() const noexcept { return counts_; }
    /// Enters the kernel only before the counting begins, never after.
    void begin() noexcept;
    /// Stops counting. @return the counts since `begin`
    SystemUse end() noexcept;

private:
    bool counts_ = false, catches_ = false;
    std::uint64_t faultsBefore_ = 0;
    SystemUse before_;
};

} // namespace burin::tests
