// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

namespace {

constexpr char message[] = "burin: this processor lacks instructions that Burin was built with (" BURIN_INSTRUCTIONS
                           "); configure it with -DBURIN_INSTRUCTIONS=x86-64 and build it again, which makes it slower "
                           "and changes no result.\n";

/// Runs before anything else in the program, so that the user reads a sentence instead of "illegal instruction". Must
/// not use any library: it may be compiled for instructions that the processor lacks.
__attribute__((constructor(101))) void requireInstructions() {
    __builtin_cpu_init();
    if (__builtin_cpu_supports(BURIN_INSTRUCTIONS)) return;
    [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, message, sizeof message - 1);
    _exit(1);
}

} // namespace
