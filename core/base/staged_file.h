// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace burin {

/// An output that is written completely before it replaces its target, so that several files of one command can be
/// written all or none. A regular file, or an unused name, is written as a temporary file next to it and replaced by a
/// rename; its permissions and, where allowed, its owner are kept. A symbolic link is followed. A FIFO, a device or a
/// socket, and descriptors of this process (/dev/stdout), are never replaced: they receive the content when it is put
/// in place. Thread: one at a time.
class StagedFile {
public:
    /// Creates the temporary file next to `file` and removes those left there by killed programs.
    /// Errors: fileNotWritable, diskFull; their subject is `file`.
    static Result<StagedFile> begin(const std::filesystem::path& file);
    /// Takes over `written`, a complete file next to `file`; as after `begin`, it is removed unless it is put in place.
    static Result<StagedFile> adopt(std::filesystem::path written, const std::filesystem::path& file);
    /// `begin`, `append` and `flush`.
    static Result<StagedFile> containing(const std::filesystem::path& file, std::string_view content);
    ~StagedFile(); ///< removes a file that was not put in place
    StagedFile(StagedFile&& other) noexcept;
    StagedFile& operator=(StagedFile&&) = delete;

    /// Appends to the content. Errors: as `begin`.
    Result<void> append(std::string_view content);
    /// Writes the content to the disk, so that `putInPlace` needs no more space. Errors: as `begin`.
    Result<void> flush();
    /// Makes it possible to restore the previous content of `file`, if the file system has links. For files that are
    /// put in place together; call it before the first of them is. Errors: diskFull, fileNotWritable; nothing was
    /// changed.
    Result<void> keepPrevious();
    /// Replaces `file` by the content, flushed together with its folder. Errors: as `begin`; the previous content is
    /// then unchanged, or the error's detail says that it is not.
    Result<void> putInPlace();
    /// Undoes `putInPlace`: restores the previous content. Returns false if that is not possible (content sent to a
    /// stream, a file system without links). Possible during the lifetime of this object.
    bool takeBack() noexcept;
    /// Whether the content was put in place and not taken back.
    bool stands() const noexcept { return state_ == State::placed; }
    const std::filesystem::path& file() const noexcept { return file_; } ///< as the user named it

private:
    enum class State : unsigned char { writing, placed, done };
    StagedFile(std::filesystem::path file, std::filesystem::path target);

    Result<void> openBeside();
    Result<void> sendToStream();
    int linkPrevious();
    bool isStream() const noexcept { return beside_.empty(); }

    std::filesystem::path file_;     ///< as the user specified it, for messages
    std::filesystem::path target_;   ///< after following symbolic links
    std::filesystem::path beside_;   ///< the temporary file; empty for a stream
    std::filesystem::path previous_; ///< another link to the former content of `target_`; empty: none, or unknown
    std::string waiting_;            ///< content for a stream
    int descriptor_ = -1;            ///< of `beside_`, locked; of a stream of this process
    bool existed_ = false;           ///< `target_` existed before
    bool looked_ = false;            ///< `existed_` and `previous_` are valid
    State state_ = State::writing;
};

/// During its lifetime, only this thread puts files in place, so that the program is not ended in the middle of it.
class PlacingTogether {
public:
    PlacingTogether();
    ~PlacingTogether();
    PlacingTogether(const PlacingTogether&) = delete;
    PlacingTogether& operator=(const PlacingTogether&) = delete;
};

/// For a program that is about to end without unwinding: waits for threads that are putting files in place, and removes
/// the other staged files. Nothing can be put in place afterwards.
void abandonStagedFiles() noexcept;

/// Puts flushed files in place, all or none. Errors: as StagedFile::putInPlace.
Result<void> putInPlace(std::span<StagedFile> files);

/// Creates the folder of a file that is to be written, and those above it, if they don't exist. Errors:
/// fileNotWritable, diskFull; their subject is `file`.
Result<void> makeFolderOf(const std::filesystem::path& file);

/// The file name, or one made of its beginning and a checksum if `suffixBytes` more would be too many for a file system
/// (255 bytes in total).
std::string nameWithRoom(const std::string& name, std::size_t suffixBytes);

/// Removes files named by `temporaryBeside(file)`, with the SQLite journals next to them, unless a running process is
/// writing them.
void removeAbandonedParts(const std::filesystem::path& file) noexcept;

/// The target of `file` after following symbolic links, which need not exist.
std::filesystem::path behindLinks(const std::filesystem::path& file);

/// The errno value that says why `target` may not be written; 0 if it may. Only the effective user's permissions count.
int refusalToWrite(const std::filesystem::path& target) noexcept;

} // namespace burin
