// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/database.h"
#include "core/document/document_state.h"

#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>

namespace burin {

/// The working copy next to the user's file (Companions), and the exclusive right to use it: a lock that the system
/// releases when its owner dies, however it dies. Shared by all writers of the copy. When the last of them is
/// destroyed, the copy is removed if everything in it was saved; otherwise it stays for the next `open`. Their
/// connections must be closed by then.
class WorkingCopy {
public:
    enum class Purpose : std::uint8_t { working, reading };
    /// @param file the user's, absolute. A lock or a copy that is a link, or not a regular file, is not ours and is
    /// left untouched. Never blocks. Errors: projectInUse, fileNotWritable, diskFull.
    static Result<std::shared_ptr<WorkingCopy>> lock(const std::filesystem::path& file,
                                                     Purpose purpose = Purpose::working);
    /// Whether the lock of a projectInUse error is held by a process that only reads leftover work.
    static bool isReading(const Error& inUse);
    /// Used to view leftover work on a disk without space for a lock, which nobody else holds either. Nothing is ever
    /// removed. Null: somebody holds a lock.
    static std::shared_ptr<WorkingCopy> withoutLock(const std::filesystem::path& file);
    ~WorkingCopy();
    WorkingCopy(const WorkingCopy&) = delete;
    WorkingCopy& operator=(const WorkingCopy&) = delete;

    const std::filesystem::path& file() const noexcept { return file_; } ///< the user's
    /// Returns the path of the copy of a file, whether or not it exists.
    static std::filesystem::path pathBeside(const std::filesystem::path& file);
    std::filesystem::path path() const { return pathBeside(file_); }
    bool exists() const;

    /// A connection to the copy: WAL, flushed at each commit. Errors: those of Database.
    Result<Database> connect() const;
    /// A connection that reads the copy as it was left, and changes nothing on the disk, which may be full.
    Result<Database> connectForReading() const;
    /// Reads the state of the copy without changing it. Errors: fileDamaged and projectNotBurin if it can't be used;
    /// other errors may be temporary.
    Result<DocumentState> state() const;
    /// Whether nothing was ever written to it, because the disk was full.
    bool hasNoContent() const;

    /// Creates a new copy: `fill` writes it, then it is flushed and renamed, so that a copy is never incomplete.
    Result<void> place(const std::function<Result<void>(Database& empty)>& fill);
    /// Moves the copy to a user-visible name, as a project of its own if it can be read, and returns that name.
    Result<std::filesystem::path> setAside();
    /// Removes the copy with its journals now, whatever it holds. No connection to it may be open.
    void discard();
    /// Marks the copy as no longer needed: it is removed with the last of its owners, saved or not.
    void abandon() noexcept { abandoned_ = true; }
    /// Removes files that a killed save left in the folder.
    void removeAbandonedParts() const;

private:
    WorkingCopy(std::filesystem::path file, int lockDescriptor);
    Result<void> takeOldNames();

    std::filesystem::path file_;
    int lock_;         ///< negative: none
    int oldLock_ = -1; ///< on the name that older versions of Burin lock
    std::atomic<bool> abandoned_{false};
};

} // namespace burin
