// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/loop/tick_thread.h"

#include <sys/mman.h>
#include <unistd.h>

// The range of the program's code, defined by the linker.
extern "C" const char __executable_start, etext;

namespace burin {
namespace {

constexpr std::size_t stackBytes = 256 * 1024; // far more than a tick uses

/// Makes the kernel provide the pages that ticks will use. @return their address, as a number, since the memory remains
/// part of the stack when this returns, but the array does not exist any more.
[[gnu::noinline]] std::uintptr_t touchStack() noexcept {
    volatile char pages[stackBytes];
    for (std::size_t i = 0; i < stackBytes; i += 1024) pages[i] = 0;
    return reinterpret_cast<std::uintptr_t>(&pages[0]);
}

#if defined(__x86_64__)
constexpr std::uint64_t denormalsAreZero = 0x8040; // MXCSR: flush to zero, denormals are zero

std::uint64_t floatingPointMode() noexcept {
    return __builtin_ia32_stmxcsr();
}
void setFloatingPointMode(std::uint64_t mode) noexcept {
    __builtin_ia32_ldmxcsr(static_cast<unsigned>(mode));
}
#elif defined(__aarch64__)
constexpr std::uint64_t denormalsAreZero = 1U << 24; // FPCR: FZ

std::uint64_t floatingPointMode() noexcept {
    std::uint64_t mode = 0;
    asm volatile("mrs %0, fpcr" : "=r"(mode));
    return mode;
}
void setFloatingPointMode(std::uint64_t mode) noexcept {
    asm volatile("msr fpcr, %0" : : "r"(mode));
}
#else
constexpr std::uint64_t denormalsAreZero = 0;
std::uint64_t floatingPointMode() noexcept {
    return 0;
}
void setFloatingPointMode(std::uint64_t) noexcept {}
#endif

} // namespace

void makeCodeResident() noexcept {
#if defined(MADV_POPULATE_READ)
    const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
    const auto begin = reinterpret_cast<std::uintptr_t>(&__executable_start) / page * page;
    const auto end = reinterpret_cast<std::uintptr_t>(&etext);
    static_cast<void>(madvise(reinterpret_cast<void*>(begin), end - begin, MADV_POPULATE_READ));
#endif
}

LockedMemory::LockedMemory(const void* begin, std::size_t bytes) noexcept
    : begin_(begin), bytes_(bytes), locked_(mlock(begin, bytes) == 0) {}

LockedMemory::~LockedMemory() {
    if (locked_) munlock(begin_, bytes_);
}

DenormalsAreZero::DenormalsAreZero() noexcept : before_(floatingPointMode()) {
    setFloatingPointMode(before_ | denormalsAreZero);
}

DenormalsAreZero::~DenormalsAreZero() {
    setFloatingPointMode(before_);
}

TickThread::TickThread() noexcept {
    stack_.emplace(reinterpret_cast<const void*>(touchStack()), stackBytes);
}

} // namespace burin
