// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/staged_file.h"
#include "core/document/database.h"

#include <cstdint>
#include <filesystem>
#include <span>

namespace burin {

/// A save that succeeded.
struct SavedSnapshot {
    std::int64_t changes = 0;          ///< DocumentState::changes of the file; counts even where the copy's note failed
    std::filesystem::path keptEarlier; ///< the name that a file of an earlier format got; empty: there was none
};

/// Makes `file` hold what the working copy holds now: a snapshot beside it, checked, flushed and renamed over it, and
/// notes in the copy that it was saved. A file of an earlier format keeps standing beside it.
/// @param outputs flushed; they are put in their places with it, all or none. Errors: diskFull, fileNotWritable,
/// fileDamaged; `file` and what stood at the outputs' names are then as they were.
Result<SavedSnapshot> saveSnapshot(Database& workingCopy, const std::filesystem::path& file,
                                   std::span<StagedFile> outputs = {});

/// Makes `file` a project of its own with what the working copy holds now. Nothing is written to the copy, so that its
/// disk may be full. @return the file in its place, which can still be taken back. Errors: as above.
Result<StagedFile> saveCopy(Database& workingCopy, const std::filesystem::path& file);

} // namespace burin
