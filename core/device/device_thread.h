// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <csignal>

namespace burin {

// Functions that the threads of drivers share.

/// Blocks all signals in the calling thread: other threads handle them, and here they would only interrupt its waits.
inline void blockSignals() noexcept {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, nullptr);
}

/// Seconds of a monotonic clock; its zero is arbitrary.
inline double steadySeconds() noexcept {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

} // namespace burin
