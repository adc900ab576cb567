// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/project/database.h"

#include <filesystem>

namespace burin {

/// Makes `file` hold what the working copy holds now: a snapshot beside it, checked, flushed and renamed over it, and
/// notes in the copy that it was saved. Errors: diskFull, fileNotWritable, fileDamaged; `file` is then as it was.
Result<void> saveSnapshot(Database& workingCopy, const std::filesystem::path& file);

/// Makes `file` a project of its own with what the working copy holds now. Nothing is written to the copy, so that its
/// disk may be full. Errors: as above.
Result<void> saveCopy(Database& workingCopy, const std::filesystem::path& file);

} // namespace burin
