// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"

#include <cstdint>
#include <filesystem>

namespace burin {

/// What a user's file is to Burin.
enum class FileKind : std::uint8_t {
    project,   ///< an SQLite database, or named .burin
    program,   ///< NC code
    locations, ///< cutter locations (APT/CL), which become a path
    model      ///< anything else: importModel says whether it is one
};

/// What a file is by its content; its name decides only where the content is missing or unknown, as that of unsaved
/// work is, which has no file yet. Reads the beginning of the file; a pipe, which could make the caller wait, is not
/// opened. Thread: any. Errors: fileNotFound, fileNotReadable (a folder, a pipe, a device, too), fileEmpty,
/// projectNotBurin.
Result<FileKind> fileKind(const std::filesystem::path& file);

} // namespace burin
