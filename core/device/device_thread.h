// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <csignal>

namespace burin {

// What the threads of drivers have in common.

/// Blocks all signals in the calling thread: they belong to the other threads, and would only interrupt its waiting.
inline void blockSignals() noexcept {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, nullptr);
}

/// s, of a clock that never goes back; its zero means nothing.
inline double steadySeconds() noexcept {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

} // namespace burin
