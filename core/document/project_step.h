// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/database.h"
#include "core/document/step_file.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

struct sqlite3_session;

namespace burin {

/// What one step of the work changed in the rows of a project, so that exactly that can be reverted: a changeset of
/// SQLite (https://www.sqlite.org/sessionintro.html). A short one is kept in memory; a longer one in a file without a
/// name in the project's folder, which all steps there share, and which ends with the last of them or with the process,
/// however that ends. It stays in memory only where no such file can be written.
class ProjectStep {
public:
    static constexpr std::size_t mostInMemory = 256 * 1024; ///< bytes of one step

    /// @param beside a file in whose folder the nameless file is made
    explicit ProjectStep(std::filesystem::path beside);
    ~ProjectStep();
    ProjectStep(const ProjectStep&) = delete;
    ProjectStep& operator=(const ProjectStep&) = delete;

    void append(std::string_view bytes); ///< @throws std::bad_alloc
    /// Returns the number of bytes read; less than `into` has room for only at the end, or if the file can't be read.
    std::size_t read(std::uint64_t from, std::span<char> into) const;
    std::uint64_t size() const noexcept { return size_; } ///< bytes
    bool inMemory() const noexcept { return file_ == nullptr; }

private:
    bool store(std::string_view bytes);
    void moveToFile();
    void moveToMemory();
    void leaveFile() noexcept;

    std::filesystem::path beside_;
    std::string memory_;
    std::uint64_t size_ = 0;
    std::shared_ptr<StepFile> file_;
    std::vector<FilePart> parts_; ///< of the file, in order
    bool staysInMemory_ = false;  ///< no file could be written
};

/// Records which rows a database's connection changes, from its beginning to `end`. While it records, the former
/// content of changed and removed rows is in memory. What is derived, or identifies the file, is left out: the tables
/// `document` and `kept_workpiece`. The database must outlive it.
class StepRecorder {
public:
    static Result<StepRecorder> begin(Database& database);
    /// Returns null if no row differs. Errors: outOfMemory.
    Result<std::shared_ptr<const ProjectStep>> end(const std::filesystem::path& beside);

private:
    struct Delete {
        void operator()(sqlite3_session* session) const noexcept;
    };
    StepRecorder(Database& database, sqlite3_session* session) : database_(&database), session_(session) {}

    Database* database_;
    std::unique_ptr<sqlite3_session, Delete> session_;
};

/// Makes the rows of a step what they were before it, whatever has become of them since. Part of its caller's
/// transaction. Errors: those of Database.
Result<void> revertRows(Database& database, const ProjectStep& step);

/// Removes the rows of setups and paths that do not exist (any more), and hides the setups' takes as `hideTake` does.
Result<void> removeOrphans(Database& database);

} // namespace burin
