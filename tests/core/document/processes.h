// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <csignal>
#include <cstdlib>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

/// For tests whose forked children start threads, which the thread sanitizer can't follow.
#ifdef __SANITIZE_THREAD__
#define BURIN_SKIP_WHERE_FORKED_CHILDREN_HAVE_NO_THREADS()                                                             \
    QSKIP("The thread sanitizer can't follow threads of a forked child.")
#else
#define BURIN_SKIP_WHERE_FORKED_CHILDREN_HAVE_NO_THREADS() static_cast<void>(0)
#endif

namespace burin::fixture {

/// Runs `work` in a child process. The result of `work` (0 … 125) is returned; -1: it died of a signal. Work that calls
/// _exit itself leaves everything as a kill does.
template <class Work>
int inAnotherProcess(Work work) {
    const pid_t child = ::fork();
    if (child == 0) ::_exit(work());
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// Starts `work` in a child, kills it after `microseconds` and waits for its end.
template <class Work>
void killedAfter(unsigned microseconds, Work work) {
    const pid_t child = ::fork();
    if (child == 0) ::_exit(work());
    ::usleep(microseconds);
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
}

/// From now on a file of this process that would grow beyond `bytes` fails with EFBIG, as with a full disk.
/// RLIM_INFINITY frees the space again.
inline void limitFileSize(rlim_t bytes) {
    ::signal(SIGXFSZ, SIG_IGN);
    rlimit limit{};
    ::getrlimit(RLIMIT_FSIZE, &limit);
    limit.rlim_cur = bytes;
    ::setrlimit(RLIMIT_FSIZE, &limit);
}

/// Root may write everywhere: for a test of missing rights, becomes the user nobody, who owns `folder` from now on.
inline void loseRights(const char* folder) {
    constexpr unsigned nobody = 65534;
    if (::geteuid() != 0) return;
    if (::chown(folder, nobody, nobody) != 0 || ::setegid(nobody) != 0 || ::seteuid(nobody) != 0) std::abort();
}

} // namespace burin::fixture
