// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/measure/tick_watch.h"

#include <cerrno>
#include <cstdlib>
#include <sys/resource.h>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define BURIN_COUNTS_ALLOCATIONS 0
#else
#define BURIN_COUNTS_ALLOCATIONS 1
#endif

namespace {

thread_local std::size_t heapCalls = 0;

std::size_t pageFaultsOfThread() noexcept {
    rusage usage{};
    ::getrusage(RUSAGE_THREAD, &usage);
    return static_cast<std::size_t>(usage.ru_minflt + usage.ru_majflt);
}

} // namespace

#if BURIN_COUNTS_ALLOCATIONS
// glibc's own, which ours count and call.
extern "C" {
void* __libc_malloc(std::size_t) noexcept;
void* __libc_calloc(std::size_t, std::size_t) noexcept;
void* __libc_realloc(void*, std::size_t) noexcept;
void* __libc_memalign(std::size_t, std::size_t) noexcept;
void __libc_free(void*) noexcept;

void* malloc(std::size_t size) noexcept {
    ++heapCalls;
    return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) noexcept {
    ++heapCalls;
    return __libc_calloc(count, size);
}
void* realloc(void* memory, std::size_t size) noexcept {
    ++heapCalls;
    return __libc_realloc(memory, size);
}
void* memalign(std::size_t alignment, std::size_t size) noexcept {
    ++heapCalls;
    return __libc_memalign(alignment, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
    ++heapCalls;
    return __libc_memalign(alignment, size);
}
int posix_memalign(void** memory, std::size_t alignment, std::size_t size) noexcept {
    ++heapCalls;
    *memory = __libc_memalign(alignment, size);
    return *memory == nullptr ? ENOMEM : 0;
}
void free(void* memory) noexcept {
    if (memory != nullptr) ++heapCalls; // giving back takes as long
    __libc_free(memory);
}
}
#endif

namespace burin::benchmarks {

bool TickWatch::countsAllocations() noexcept {
    return BURIN_COUNTS_ALLOCATIONS != 0;
}

void TickWatch::begin() noexcept {
    counting_ = true;
    allocationsBefore_ = heapCalls;
    faultsBefore_ = pageFaultsOfThread();
}

void TickWatch::end() noexcept {
    if (!counting_) return;
    counting_ = false;
    allocations_ += heapCalls - allocationsBefore_;
    pageFaults_ += pageFaultsOfThread() - faultsBefore_;
}

} // namespace burin::benchmarks
