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

/// The copy that one works on, beside the user's file (Companions), and the right to do so: a lock that the system
/// takes back when its owner dies, however it dies. Shared by everybody who writes to the copy. When the last of them
/// is gone the copy is removed if everything in it was saved, and stays for the next `open` otherwise. Their
/// connections must be closed by then.
class WorkingCopy {
public:
    enum class Purpose : std::uint8_t { working, reading };
    /// @param file the user's, absolute. A lock or a copy that is a link, or no regular file, is not ours and is not
    /// touched. Never waits. Errors: projectInUse, fileNotWritable, diskFull.
    static Result<std::shared_ptr<WorkingCopy>> lock(const std::filesystem::path& file,
                                                     Purpose purpose = Purpose::working);
    /// Of a projectInUse: whether its lock is held by one who only reads work that was left.
    static bool isReading(const Error& inUse);
    /// For looking at what was left on a disk that has no room for a lock, which nobody else has either. Nothing is
    /// ever removed. Null: somebody has a lock.
    static std::shared_ptr<WorkingCopy> withoutLock(const std::filesystem::path& file);
    ~WorkingCopy();
    WorkingCopy(const WorkingCopy&) = delete;
    WorkingCopy& operator=(const WorkingCopy&) = delete;

    const std::filesystem::path& file() const noexcept { return file_; } ///< the user's
    /// Where the copy of a file stands, whether or not it is there.
    static std::filesystem::path pathBeside(const std::filesystem::path& file);
    std::filesystem::path path() const { return pathBeside(file_); }
    bool exists() const;

    /// A connection to the copy: WAL, flushed at each commit. Errors: those of Database.
    Result<Database> connect() const;
    /// A connection that reads the copy as it was left, and changes nothing on the disk, which may be full.
    Result<Database> connectForReading() const;
    /// State of the copy without changing it. Errors: fileDamaged and projectNotBurin where it can't be used; others
    /// are faults that may pass.
    Result<DocumentState> state() const;
    /// Nothing was ever written to it: a disk that was full left no more.
    bool hasNoContent() const;

    /// Puts a new copy in place: `fill` writes it, then it is flushed and renamed, so that a copy is never half made.
    Result<void> place(const std::function<Result<void>(Database& empty)>& fill);
    /// Moves the copy to a name that the user sees, as a project of its own where it can be read, and returns it.
    Result<std::filesystem::path> setAside();
    /// Removes the copy with its journals now, whatever it holds. No connection to it may be open.
    void discard();
    /// Nobody needs the copy any more: it goes with the last of its owners, saved or not.
    void abandon() noexcept { abandoned_ = true; }
    /// Removes what a killed save left in the folder.
    void removeAbandonedParts() const;

private:
    WorkingCopy(std::filesystem::path file, int lockDescriptor);
    Result<void> takeOldNames();

    std::filesystem::path file_;
    int lock_;         ///< negative: none
    int oldLock_ = -1; ///< of the name that an older Burin locks
    std::atomic<bool> abandoned_{false};
};

} // namespace burin
