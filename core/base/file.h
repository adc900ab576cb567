// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace burin {

/// A stream at the beginning of a file, binary. Errors: fileNotFound, fileNotReadable (a folder, too).
Result<std::ifstream> openFileStream(const std::filesystem::path& file);

/// The whole content of a file, a pipe or a device. Errors: fileNotFound, fileNotReadable, outOfMemory (subject: the
/// file).
Result<std::string> readFile(const std::filesystem::path& file);

/// Writes `content` beside `file`, flushes it to the disk and renames it over `file`: afterwards either the complete
/// new content stands there or what stood there before. Links, rights, FIFOs and devices: as StagedFile, which is for
/// several files that belong together. Errors: fileNotWritable, diskFull.
Result<void> writeFileAtomically(const std::filesystem::path& file, std::string_view content);

/// Flushes `written` to the disk and renames it over `file`. For libraries that write a file by themselves: let them
/// write to `temporaryBeside(file)`. On failure `written` is removed. The rename lasts through a loss of power where
/// the folder may be read and its file system can flush one; else as far as that file system sees to it.
/// Errors: fileNotWritable, diskFull; what stood there stands there still.
Result<void> replaceFile(const std::filesystem::path& written, const std::filesystem::path& file);

/// A name in the folder of `file` that nobody else uses, for writing beside it; short enough for any `file`.
std::filesystem::path temporaryBeside(const std::filesystem::path& file);

/// The error that `errno` value `systemError` means for reading `file`.
Error readError(const std::filesystem::path& file, int systemError);

/// The error that `errno` value `systemError` means for writing `file`.
Error writeError(const std::filesystem::path& file, int systemError);

/// Folder of the running program.
std::filesystem::path executableDirectory();

/// Folder of the data that Burin is shipped with: ../share/burin/resources of an installed program; in the build tree
/// `resources` beside the program, or one folder up from a test.
std::filesystem::path resourceDirectory();

/// Folder of the plugins that Burin is shipped with: ../lib/burin/plugins, or `plugins` in the build tree.
std::filesystem::path pluginDirectory();

/// Folder of the compiled translations: ../share/burin/translations, or `translations` in the build tree.
std::filesystem::path translationDirectory();

} // namespace burin
