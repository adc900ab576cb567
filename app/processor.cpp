// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

namespace {

constexpr char message[] = "burin: this processor lacks instructions that Burin was built with (" BURIN_INSTRUCTIONS
                           "); configure it with -DBURIN_INSTRUCTIONS=x86-64 and build it again, which makes it slower "
                           "and changes no result.\n";

/// Before anything else of the program, so that its user reads a sentence instead of "illegal instruction". Nothing of
/// any library: it may be built for more than there is.
__attribute__((constructor(101))) void requireInstructions() {
    __builtin_cpu_init();
    if (__builtin_cpu_supports(BURIN_INSTRUCTIONS)) return;
    [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, message, sizeof message - 1);
    _exit(1);
}

} // namespace
