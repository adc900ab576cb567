// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

namespace burin {

/// Unsaved work that an ended program left in a folder: `Project::open` of `file` recovers it.
struct LeftWork {
    std::filesystem::path file;
    std::filesystem::file_time_type changed; ///< time of its last write
};

struct FoundWork {
    std::vector<LeftWork> left; ///< the newest first, without unreadable ones
    /// Another program has work open, which is not listed: it is running, or it was killed and is still terminating
    /// (delayed by a busy disk), in which case its work can be recovered soon.
    bool inUse = false;
};

/// Checks each working copy of a folder, holding its lock meanwhile. Nothing is found in a folder that can't be read.
/// Not for the GUI thread, as it waits for the disk.
FoundWork leftWork(const std::filesystem::path& folder);

} // namespace burin
