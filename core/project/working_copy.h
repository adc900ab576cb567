// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/project/database.h"
#include "core/project/document_state.h"

#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

namespace burin {

/// The copy that one works on, `.<name>.working` beside the user's file, and the right to do so: a lock on
/// `.<name>.lock` that the system takes back when its owner dies, however it dies.
/// Shared by everybody who writes to the copy. When the last of them is gone the copy is removed if everything in it
/// was saved, and stays for the next `open` otherwise. Their connections must be closed by then.
class WorkingCopy {
public:
    /// Errors: projectInUse, fileNotWritable, diskFull.
    static Result<std::shared_ptr<WorkingCopy>> lock(const std::filesystem::path& file);
    ~WorkingCopy();
    WorkingCopy(const WorkingCopy&) = delete;
    WorkingCopy& operator=(const WorkingCopy&) = delete;

    const std::filesystem::path& file() const noexcept { return file_; } ///< the user's
    static std::filesystem::path pathBeside(const std::filesystem::path& file);
    std::filesystem::path path() const { return pathBeside(file_); }
    bool exists() const;

    /// A connection to the copy: WAL, flushed at each commit. Errors: those of Database.
    Result<Database> connect() const;
    /// State of the copy without changing it; nothing when it can't be read.
    std::optional<DocumentState> state() const;

    /// Puts a new copy in place: `fill` writes it, then it is flushed and renamed, so that a copy is never half made.
    Result<void> place(const std::function<Result<void>(Database& empty)>& fill);
    /// Moves the copy to a name that the user sees, as a project of its own where it can be read, and says which.
    Result<std::filesystem::path> setAside();
    void discard();
    /// Nobody wants the copy any more: it goes with the last of its owners, saved or not.
    void abandon() noexcept { abandoned_ = true; }
    /// Removes what a killed save left in the folder.
    void removeAbandonedParts() const;

private:
    WorkingCopy(std::filesystem::path file, int lockDescriptor);

    std::filesystem::path file_;
    int lock_;
    std::atomic<bool> abandoned_{false};
};

} // namespace burin
