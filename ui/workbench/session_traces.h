// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace burin {

/// Names the files of the traces of sessions, one a session.
class SessionTraces {
public:
    /// @param file of the next session's trace; empty: none is recorded any more
    void choose(const std::filesystem::path& file);
    const std::filesystem::path& chosen() const noexcept { return chosen_; }

    /// A session begins. @return the file of its trace: the chosen one; after its session, one next to it with a number
    /// that does not exist yet. Empty: none
    std::filesystem::path begin();
    /// The trace of the session can't be written, or its session did not begin.
    void drop() noexcept { now_.clear(); }
    /// The session has ended. @return the file of its trace; empty: there is none, as it was not recorded or its
    /// session failed
    std::filesystem::path end();
    const std::filesystem::path& now() const noexcept { return now_; } ///< empty: none

private:
    std::filesystem::path chosen_, now_;
    int number_ = 1; ///< of the next file
};

} // namespace burin
