// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

namespace burin {

/// Unsaved work that a program which is gone left in a folder: `Project::open` of `file` takes it up again.
struct LeftWork {
    std::filesystem::path file;
    std::filesystem::file_time_type changed; ///< when it was written last
};

struct FoundWork {
    std::vector<LeftWork> left; ///< the newest first, without what can't be read
    /// A program has some open, which is not listed: it runs, or it was killed and is still ending (a disk that is busy
    /// holds it up), and its work is left soon.
    bool inUse = false;
};

/// Looks into each working copy of a folder, and holds its lock meanwhile. A folder that can't be read has none. Not
/// for the window's thread: it waits for the disk.
FoundWork leftWork(const std::filesystem::path& folder);

} // namespace burin
