// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/staged_file.h"
#include "core/project/database.h"

#include <cstdint>
#include <filesystem>
#include <span>

namespace burin {

/// Makes `file` hold what the working copy holds now: a snapshot beside it, checked, flushed and renamed over it, and
/// notes in the copy that it was saved. @param outputs flushed; they are put in their places with it, all or none.
/// @return DocumentState::changes of the file, which counts even where the note failed. Errors: diskFull,
/// fileNotWritable, fileDamaged; `file` and what stood at the outputs' names are then as they were.
Result<std::int64_t> saveSnapshot(Database& workingCopy, const std::filesystem::path& file,
                                  std::span<StagedFile> outputs = {});

/// Makes `file` a project of its own with what the working copy holds now. Nothing is written to the copy, so that its
/// disk may be full. @return the file in its place, which can still be taken back. Errors: as above.
Result<StagedFile> saveCopy(Database& workingCopy, const std::filesystem::path& file);

} // namespace burin
