// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace burin {

/// Names of the files that Burin keeps in the folder of a project `file` while it is open. If the file name is too long
/// for them, they are shortened (nameWithRoom), so that every name works that the file system allows.
struct Companions {
    std::filesystem::path working, lock;
    /// @param file absolute
    static Companions of(const std::filesystem::path& file);
    /// The names that Burin used before it shortened them; the same if no shortening is needed.
    static Companions unshortened(const std::filesystem::path& file);
};

/// Returns a user-visible name in the folder of `file`: "p.LABEL.burin", shortened if it would be too long.
/// @param label at most 12 bytes
std::filesystem::path labelledBeside(const std::filesystem::path& file, const std::string& label);

/// Returns `file` with `ending` added to its name.
std::filesystem::path withEnding(const std::filesystem::path& file, const char* ending);

/// The endings of the files that SQLite keeps for a database, and the empty one of the database itself.
inline constexpr const char* databaseEndings[] = {"-wal", "-shm", "-journal", ""};

/// Removes a database with its journals, the journals first: SQLite would replay them into the next database of that
/// name.
void removeDatabase(const std::filesystem::path& file) noexcept;

/// Checks that `file` is none of `others` and none of their companions, including through links.
/// @param argument name of the argument that states the file, for the error's subject
/// @param others files and projects; empty ones are ignored
/// Errors: argumentInvalid.
Result<void> checkDistinct(const std::string& argument, const std::filesystem::path& file,
                           std::span<const std::filesystem::path> others);

/// Checks that a command may write its output there: it is none of the files that it reads, none of their companions,
/// and no folder. A name that does not exist yet, a regular file, a FIFO and a device are allowed.
/// Errors: argumentInvalid, fileNotWritable (a folder, or a file that may not be written).
Result<void> checkOutput(const std::string& argument, const std::filesystem::path& output,
                         std::span<const std::filesystem::path> inputs);

} // namespace burin
