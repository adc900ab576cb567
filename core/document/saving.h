// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/staged_file.h"
#include "core/document/database.h"

#include <cstdint>
#include <filesystem>
#include <span>

namespace burin {

/// The result of a successful save.
struct SavedSnapshot {
    std::int64_t changes = 0;          ///< DocumentState::changes of the file; valid even if the note in the copy
                                       ///< failed
    std::filesystem::path keptEarlier; ///< new name of a replaced file of an earlier format; empty: there was none
};

/// Saves the current content of the working copy to `file`: a snapshot next to it is checked, flushed and renamed over
/// it, and the copy gets a note that it was saved. A file of an earlier format is kept under another name.
/// @param outputs flushed; they are moved to their final names with it, all or none. Errors: diskFull, fileNotWritable,
/// fileDamaged; `file` and the files of the outputs' names are then unchanged.
Result<SavedSnapshot> saveSnapshot(Database& workingCopy, const std::filesystem::path& file,
                                   std::span<StagedFile> outputs = {});

/// Saves the current content of the working copy as a separate project `file`. Nothing is written to the copy, so its
/// disk may be full. @return the file in its place, which can still be reverted. Errors: as above.
Result<StagedFile> saveCopy(Database& workingCopy, const std::filesystem::path& file);

} // namespace burin
