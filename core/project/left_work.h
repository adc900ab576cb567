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

/// The newest first; work that a running program has open is not listed, nor what can't be read.
std::vector<LeftWork> leftWork(const std::filesystem::path& folder);

} // namespace burin
