// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace burin {

/// Names of the files that Burin keeps beside a project `file` while it is open. Those of a file name that leaves no
/// room for them are shortened (nameWithRoom), so that any name works that the file system takes.
struct Companions {
    std::filesystem::path working, lock;
    /// @param file absolute
    static Companions of(const std::filesystem::path& file);
    /// As Burin named them before names were shortened; the same where that needs none.
    static Companions unshortened(const std::filesystem::path& file);
};

/// A name beside `file` that the user sees: "p.LABEL.burin", shortened where there is no room for it.
/// @param label at most 12 bytes
std::filesystem::path labelledBeside(const std::filesystem::path& file, const std::string& label);

/// `file` with `ending` added to its name.
std::filesystem::path withEnding(const std::filesystem::path& file, const char* ending);

/// The endings of the files that SQLite keeps for a database, with the database's own.
inline constexpr const char* databaseEndings[] = {"-wal", "-shm", "-journal", ""};

/// Removes a database with its journals, these first: SQLite would play them back into the next one of that name.
void removeDatabase(const std::filesystem::path& file) noexcept;

/// Whether `file` is none of `others` and none of their companions, whatever links lead there.
/// @param argument that names the file, for the error's subject @param others files and projects, empty ones ignored
/// Errors: argumentInvalid.
Result<void> checkDistinct(const std::string& argument, const std::filesystem::path& file,
                           std::span<const std::filesystem::path> others);

/// Whether a command may write its output there: it is none of the files that it reads and none of their companions,
/// and no folder. A name that nothing has yet, a regular file, a FIFO and a device will do.
/// Errors: argumentInvalid, fileNotWritable (a folder, a file that may not be written).
Result<void> checkOutput(const std::string& argument, const std::filesystem::path& output,
                         std::span<const std::filesystem::path> inputs);

} // namespace burin
