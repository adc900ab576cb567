// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"

#include <cstdint>
#include <filesystem>

namespace burin {

/// The kinds of files that a user may open with Burin.
enum class FileKind : std::uint8_t {
    project,   ///< an SQLite database, or named .burin
    program,   ///< NC code
    locations, ///< cutter locations (APT/CL), which become a path
    model      ///< anything else: importModel finds out whether it is one
};

/// Returns the kind of a file by its content; its name decides only if the content is missing or unknown, as with
/// unsaved work, which has no file yet. Reads the beginning of the file; a pipe, which could block the caller, is not
/// opened. Thread-safe. Errors: fileNotFound, fileNotReadable (also a folder, a pipe or a device), fileEmpty,
/// projectNotBurin.
Result<FileKind> fileKind(const std::filesystem::path& file);

} // namespace burin
