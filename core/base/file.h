// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace burin {

/// A binary stream at the beginning of a file. Errors: fileNotFound, fileNotReadable (also for a folder).
Result<std::ifstream> openFileStream(const std::filesystem::path& file);

/// The whole content of a file, a pipe or a device. Errors: fileNotFound, fileNotReadable, outOfMemory (subject: the
/// file).
Result<std::string> readFile(const std::filesystem::path& file);

/// Writes `content` to a temporary file next to `file`, flushes it to the disk and renames it to `file`: afterwards
/// `file` has either the complete new content or its previous one. For links, permissions, FIFOs and devices see
/// StagedFile, which is meant for several files that belong together. Errors: fileNotWritable, diskFull.
Result<void> writeFileAtomically(const std::filesystem::path& file, std::string_view content);

/// Flushes `written` to the disk and renames it to `file`. For libraries that write a file by themselves: let them
/// write to `temporaryBeside(file)`. On failure `written` is removed. The rename survives a loss of power if the folder
/// is readable and its file system can flush it; otherwise as far as the file system ensures it. Errors:
/// fileNotWritable, diskFull; `file` then has its previous content.
Result<void> replaceFile(const std::filesystem::path& written, const std::filesystem::path& file);

/// An unused name in the folder of `file`, for a temporary file; short enough for any `file`.
std::filesystem::path temporaryBeside(const std::filesystem::path& file);

/// The error that `errno` value `systemError` means for reading `file`.
Error readError(const std::filesystem::path& file, int systemError);

/// The error that `errno` value `systemError` means for writing `file`.
Error writeError(const std::filesystem::path& file, int systemError);

/// Folder of the running program.
std::filesystem::path executableDirectory();

/// Folder of the data shipped with Burin: ../share/burin/resources of an installed program; in the build tree
/// `resources` next to the program, or one folder up from a test.
std::filesystem::path resourceDirectory();

/// Folder of the plugins shipped with Burin: ../lib/burin/plugins, or `plugins` in the build tree.
std::filesystem::path pluginDirectory();

/// Folder of the compiled translations: ../share/burin/translations, or `translations` in the build tree.
std::filesystem::path translationDirectory();

} // namespace burin
