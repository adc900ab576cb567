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

/// An output that is written first and put in its place at the end, so that several files of one command can be
/// written all or none. A regular file, or a name that nothing has, is written beside it and replaced by a rename;
/// its rights and, where allowed, its owner stay. A symbolic link is followed. A FIFO, a device or a socket, and
/// descriptors of this process (/dev/stdout), are never replaced: they get the content when it is put in place.
/// Thread: one at a time.
class StagedFile {
public:
    /// Makes the file beside `file` and removes those that killed programs left there.
    /// Errors: fileNotWritable, diskFull; their subject is `file`.
    static Result<StagedFile> begin(const std::filesystem::path& file);
    /// Takes over `written`, a complete file beside `file`; as from `begin` it is removed unless it is put in place.
    static Result<StagedFile> adopt(std::filesystem::path written, const std::filesystem::path& file);
    /// `begin`, `append` and `flush`.
    static Result<StagedFile> containing(const std::filesystem::path& file, std::string_view content);
    ~StagedFile(); ///< what was not put in place is removed
    StagedFile(StagedFile&& other) noexcept;
    StagedFile& operator=(StagedFile&&) = delete;

    /// Adds to the content. Errors: as `begin`.
    Result<void> append(std::string_view content);
    /// What was appended is on the disk: nothing of `putInPlace` needs room any more. Errors: as `begin`.
    Result<void> flush();
    /// From now on what stands at `file` can be brought back, where the file system has links. For files that are put
    /// in their places together, before the first of them is. Errors: diskFull, fileNotWritable; nothing was changed.
    Result<void> keepPrevious();
    /// The content stands at `file`, flushed with its folder. Errors: as `begin`; what stood there before then stands
    /// there still, or the error's detail says that it does not.
    Result<void> putInPlace();
    /// Undoes `putInPlace`: what stood there before stands there again. False: it can't be undone (what was sent to a
    /// stream, a file system without links). Until this object ends.
    bool takeBack() noexcept;
    /// Whether the content stands at `file` and was not taken back.
    bool stands() const noexcept { return state_ == State::placed; }
    const std::filesystem::path& file() const noexcept { return file_; } ///< as the user named it

private:
    enum class State : unsigned char { writing, placed, done };
    StagedFile(std::filesystem::path file, std::filesystem::path target);

    Result<void> openBeside();
    Result<void> sendToStream();
    int linkPrevious();
    bool isStream() const noexcept { return beside_.empty(); }

    std::filesystem::path file_;     ///< as the user named it, for messages
    std::filesystem::path target_;   ///< behind its links
    std::filesystem::path beside_;   ///< what is written; empty for a stream
    std::filesystem::path previous_; ///< another name of what stood at `target_`; empty: nothing did, or unknown
    std::string waiting_;            ///< for a stream
    int descriptor_ = -1;            ///< of `beside_`, locked; of a stream of this process
    bool existed_ = false;           ///< something stood at `target_`
    bool looked_ = false;            ///< `existed_` and `previous_` are known
    State state_ = State::writing;
};

/// While it lives, this thread alone puts files in their places, so that nobody ends the program in the middle of it.
class PlacingTogether {
public:
    PlacingTogether();
    ~PlacingTogether();
    PlacingTogether(const PlacingTogether&) = delete;
    PlacingTogether& operator=(const PlacingTogether&) = delete;
};

/// For a program that is about to end without unwinding: waits for whoever is putting files in their places, and
/// removes what was not. Nothing can be put in its place afterwards.
void abandonStagedFiles() noexcept;

/// Puts flushed files in their places, all or none. Errors: as StagedFile::putInPlace.
Result<void> putInPlace(std::span<StagedFile> files);

/// The file name, or one that is made of its beginning and a checksum where `suffixBytes` more would be too many for
/// a file system (255 bytes in all).
std::string nameWithRoom(const std::string& name, std::size_t suffixBytes);

/// Removes files that `temporaryBeside(file)` named, with the journals of SQLite beside them, and that no living
/// process writes.
void removeAbandonedParts(const std::filesystem::path& file) noexcept;

/// The file behind `file`'s symbolic links, which need not exist.
std::filesystem::path behindLinks(const std::filesystem::path& file);

/// The errno value that says why `target` may not be written; 0: it may. Only the effective user's rights count.
int refusalToWrite(const std::filesystem::path& target) noexcept;

} // namespace burin
