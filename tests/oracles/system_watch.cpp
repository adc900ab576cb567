// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/system_watch.h"

#if defined(__linux__) && defined(__x86_64__) && defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) &&               \
    !defined(__SANITIZE_THREAD__) && !defined(__clang__)
#define BURIN_SYSTEM_WATCH 1
#endif

#ifdef BURIN_SYSTEM_WATCH

#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <dlfcn.h>
#include <pthread.h>
#include <semaphore.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <ucontext.h>
#include <unistd.h>

#ifndef PR_SET_SYSCALL_USER_DISPATCH
#define PR_SET_SYSCALL_USER_DISPATCH 59
#define PR_SYS_DISPATCH_OFF 0
#define PR_SYS_DISPATCH_ON 1
#endif

namespace {

constexpr char allow = 0, block = 1; // SYSCALL_DISPATCH_FILTER_*

// Initialised without code and accessed without a call, so that malloc itself may use them.
__attribute__((tls_model("initial-exec"))) thread_local burin::tests::SystemUse counted;
__attribute__((tls_model("initial-exec"))) thread_local volatile char selector = allow;

template <class Function>
Function* next(const char* name) noexcept {
    return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name)); // POSIX: dlsym returns functions as void*
}

/// Repeats the caught system call with the number and the six arguments from its registers.
long long passOn(const greg_t* registers) noexcept {
    register long long r10 asm("r10") = registers[REG_R10];
    register long long r8 asm("r8") = registers[REG_R8];
    register long long r9 asm("r9") = registers[REG_R9];
    long long answer = registers[REG_RAX];
    asm volatile("syscall"
                 : "+a"(answer)
                 : "D"(registers[REG_RDI]), "S"(registers[REG_RSI]), "d"(registers[REG_RDX]), "r"(r10), "r"(r8), "r"(r9)
                 : "rcx", "r11", "memory");
    return answer;
}

void caught(int, siginfo_t* info, void* context) {
    const int errorBefore = errno;
    selector = allow;
    ++counted.systemCalls;
    greg_t* registers = static_cast<ucontext_t*>(context)->uc_mcontext.gregs;
    registers[REG_RAX] = info->si_syscall;
    registers[REG_RAX] = passOn(registers);
    errno = errorBefore;
    selector = block; // the system call for the return from here lies in the range that is always let through
}

/// The kernel's own structure for a signal action: glibc hides the address that a handler returns to.
struct KernelAction {
    void (*handler)(int);
    unsigned long flags;
    void (*restorer)();
    unsigned long mask;
};

bool catchSystemCalls() noexcept {
    struct sigaction action {};
    action.sa_sigaction = caught;
    action.sa_flags = SA_SIGINFO;
    sigfillset(&action.sa_mask);
    if (sigaction(SIGSYS, &action, nullptr) != 0) return false;
    KernelAction known{};
    if (syscall(SYS_rt_sigaction, SIGSYS, nullptr, &known, sizeof known.mask) != 0) return false;
    constexpr unsigned long restorerSize = 16; // mov $15, %rax; syscall
    return prctl(PR_SET_SYSCALL_USER_DISPATCH, PR_SYS_DISPATCH_ON, reinterpret_cast<unsigned long>(known.restorer),
                 restorerSize, const_cast<char*>(&selector)) == 0;
}

std::uint64_t pageFaults() noexcept {
    rusage usage{};
    getrusage(RUSAGE_THREAD, &usage);
    return static_cast<std::uint64_t>(usage.ru_minflt + usage.ru_majflt);
}

} // namespace

extern "C" {
// glibc's internal names of the replaced functions.
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
void __libc_free(void* memory);

void* malloc(std::size_t size) {
    ++counted.allocations;
    return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) {
    ++counted.allocations;
    return __libc_calloc(count, size);
}
void* realloc(void* memory, std::size_t size) {
    ++counted.allocations;
    return __libc_realloc(memory, size);
}
void* memalign(std::size_t alignment, std::size_t size) {
    ++counted.allocations;
    return __libc_memalign(alignment, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
    ++counted.allocations;
    return __libc_memalign(alignment, size);
}
int posix_memalign(void** memory, std::size_t alignment, std::size_t size) {
    ++counted.allocations;
    void* const found = __libc_memalign(alignment, size);
    if (found == nullptr) return ENOMEM;
    *memory = found;
    return 0;
}
void free(void* memory) {
    if (memory != nullptr) ++counted.releases;
    __libc_free(memory);
}

// Each of these functions counts and forwards the call.
#define BURIN_COUNT_LOCK(name, parameters, arguments)                                                                  \
    int name parameters noexcept {                                                                                     \
        static auto* const original = next<int parameters>(#name);                                                     \
        ++counted.locks;                                                                                               \
        return original arguments;                                                                                     \
    }
BURIN_COUNT_LOCK(pthread_mutex_lock, (pthread_mutex_t * mutex), (mutex))
BURIN_COUNT_LOCK(pthread_mutex_trylock, (pthread_mutex_t * mutex), (mutex))
BURIN_COUNT_LOCK(pthread_mutex_timedlock, (pthread_mutex_t * mutex, const timespec* until), (mutex, until))
BURIN_COUNT_LOCK(pthread_mutex_clocklock, (pthread_mutex_t * mutex, clockid_t clock, const timespec* until),
                 (mutex, clock, until))
BURIN_COUNT_LOCK(pthread_rwlock_rdlock, (pthread_rwlock_t * lock), (lock))
BURIN_COUNT_LOCK(pthread_rwlock_wrlock, (pthread_rwlock_t * lock), (lock))
BURIN_COUNT_LOCK(pthread_rwlock_tryrdlock, (pthread_rwlock_t * lock), (lock))
BURIN_COUNT_LOCK(pthread_rwlock_trywrlock, (pthread_rwlock_t * lock), (lock))
BURIN_COUNT_LOCK(pthread_spin_lock, (pthread_spinlock_t * lock), (lock))
BURIN_COUNT_LOCK(pthread_spin_trylock, (pthread_spinlock_t * lock), (lock))
BURIN_COUNT_LOCK(sem_trywait, (sem_t * semaphore), (semaphore))
#undef BURIN_COUNT_LOCK
// These are points of cancellation, hence not noexcept in glibc's headers.
#define BURIN_COUNT_WAIT(name, parameters, arguments)                                                                  \
    int name parameters {                                                                                              \
        static auto* const original = next<int parameters>(#name);                                                     \
        ++counted.locks;                                                                                               \
        return original arguments;                                                                                     \
    }
BURIN_COUNT_WAIT(sem_wait, (sem_t * semaphore), (semaphore))
BURIN_COUNT_WAIT(pthread_cond_wait, (pthread_cond_t * condition, pthread_mutex_t* mutex), (condition, mutex))
BURIN_COUNT_WAIT(pthread_cond_timedwait, (pthread_cond_t * condition, pthread_mutex_t* mutex, const timespec* until),
                 (condition, mutex, until))
BURIN_COUNT_WAIT(pthread_cond_clockwait,
                 (pthread_cond_t * condition, pthread_mutex_t* mutex, clockid_t clock, const timespec* until),
                 (condition, mutex, clock, until))
#undef BURIN_COUNT_WAIT
}

namespace burin::tests {

SystemWatch::SystemWatch(Watched watched)
    : counts_(watched == Watched::butSystemCalls || catchSystemCalls())
    , catches_(counts_ && watched == Watched::everything) {}

SystemWatch::~SystemWatch() {
    selector = allow;
    if (catches_) prctl(PR_SET_SYSCALL_USER_DISPATCH, PR_SYS_DISPATCH_OFF, 0, 0, 0);
}

void SystemWatch::begin() noexcept {
    if (!counts_) return;
    faultsBefore_ = pageFaults();
    before_ = counted;
    if (catches_) selector = block;
}

SystemUse SystemWatch::end() noexcept {
    selector = allow;
    if (!counts_) return {};
    const SystemUse now = counted;
    return {now.allocations - before_.allocations, now.releases - before_.releases, now.locks - before_.locks,
            now.systemCalls - before_.systemCalls, pageFaults() - faultsBefore_};
}

} // namespace burin::tests

#else

namespace burin::tests {

SystemWatch::SystemWatch(Watched) {}
SystemWatch::~SystemWatch() = default;
void SystemWatch::begin() noexcept {}
SystemUse SystemWatch::end() noexcept {
    return {};
}

} // namespace burin::tests

#endif
