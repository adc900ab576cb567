// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/document/saving.h"

#include "core/base/file.h"
#include "core/document/companions.h"
#include "core/document/document_state.h"
#include "core/document/schema.h"

#include <cerrno>
#include <fcntl.h>
#include <string>
#include <unistd.h>
#include <utility>

namespace burin {

namespace fs = std::filesystem;

namespace {

/// A removed recording leaves free pages behind; a file that consists mostly of these is written anew.
Result<void> dropFreePages(Database& snapshot) {
    const Result<std::int64_t> free = snapshot.integer("PRAGMA freelist_count");
    if (!free) return free.error();
    const Result<std::int64_t> all = snapshot.integer("PRAGMA page_count");
    if (!all) return all.error();
    if (*free * 4 < *all) return {};
    return snapshot.execute("VACUUM");
}

/// Writes the snapshot; returns its state as a saved file.
Result<DocumentState> writeSnapshot(Database& workingCopy, const fs::path& beside, const std::string& saveId) {
    const int made = ::open(beside.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (made < 0) return writeError(workingCopy.subject(), errno);
    ::close(made);
    Result<Database> snapshot = Database::open(beside, workingCopy.subject(), Database::Access::create);
    if (!snapshot) return std::move(snapshot).error();
    // No journal and no flush: an incomplete snapshot is discarded, and a complete one is flushed before the rename.
    for (const char* setting : {"PRAGMA journal_mode = MEMORY", "PRAGMA synchronous = OFF"})
        if (Result<void> done = snapshot->execute(setting); !done) return std::move(done).error();
    if (Result<void> done = copyDatabase(workingCopy, *snapshot); !done) return std::move(done).error();
    if (Result<void> done = snapshot->execute("PRAGMA journal_mode = DELETE"); !done) return std::move(done).error();
    if (Result<void> done = dropFreePages(*snapshot); !done) return std::move(done).error();

    Result<DocumentState> state = documentState(*snapshot);
    if (!state) return state;
    const Result<std::int64_t> digest = contentDigest(*snapshot);
    if (!digest) return digest.error();
    state->saveId = saveId;
    state->nextSaveId.clear();
    state->revision += 1;
    state->savedChanges = state->changes;
    state->digest = *digest;
    if (Result<void> done = setDocumentState(*snapshot, *state); !done) return std::move(done).error();
    if (Result<void> done = snapshot->quickCheck(); !done) return std::move(done).error();
    return state;
}

/// Checks that the rename would not bypass a write protection of the file.
Result<void> mayBeReplaced(const fs::path& file) {
    if (const int refused = refusalToWrite(file); refused != 0) return writeError(file, refused);
    return {};
}

/// Moves `outputs` to their final names and then the project: all or none.
Result<void> placeTogether(StagedFile& project, std::span<StagedFile> outputs) {
    const PlacingTogether alone;
    if (!outputs.empty())
        if (Result<void> kept = project.keepPrevious(); !kept) return kept;
    for (StagedFile& output : outputs)
        if (Result<void> kept = output.keepPrevious(); !kept) return kept;
    if (Result<void> placed = putInPlace(outputs); !placed) return placed;
    Result<void> placed = project.putInPlace();
    if (!placed)
        for (StagedFile& output : outputs) output.takeBack();
    return placed;
}

/// Returns the format of `file`; 0 if it is not a readable project.
int formatOf(const fs::path& file) {
    Result<Database> database = Database::open(file, file.string(), Database::Access::read);
    if (!database || !checkIdentity(*database)) return 0;
    const Result<std::int64_t> version = database->integer("PRAGMA user_version");
    return version ? static_cast<int>(*version) : 0;
}

/// Gives `file` a second name, or, if the file system has no links, makes a copy of that name, completely or not at
/// all. The name must not exist yet. Errors: those of writing.
Result<void> giveName(const fs::path& file, const fs::path& name) {
    std::error_code failed;
    fs::create_hard_link(file, name, failed);
    if (!failed) return {};
    const fs::path beside = temporaryBeside(file);
    fs::copy_file(file, beside, failed);
    if (!failed) fs::rename(beside, name, failed);
    if (!failed) return {};
    std::error_code ignored;
    fs::remove(beside, ignored);
    return writeError(name, failed.value());
}

/// Gives another name to a file of an earlier format before a save replaces it, as older versions of Burin can't read
/// the new one. Uses the first free name, or that of a previous incomplete save; empty if the file already has the
/// present format. Errors: those of writing.
Result<fs::path> keepEarlierFormat(const fs::path& file) {
    const int format = formatOf(file);
    if (format < 1 || format >= projectVersion) return fs::path();
    const std::string label = "format-" + std::to_string(format);
    std::error_code ignored;
    fs::path name = labelledBeside(file, label);
    for (int number = 2; fs::exists(fs::symlink_status(name, ignored)); ++number) {
        if (fs::equivalent(file, name, ignored)) return name;
        name = labelledBeside(file, label + "-" + std::to_string(number));
    }
    if (Result<void> named = giveName(file, name); !named) return std::move(named).error();
    return name;
}

/// A snapshot next to `file`, complete and flushed, and its state as a saved file.
struct StagedSnapshot {
    StagedFile file;
    DocumentState state;
};

Result<StagedSnapshot> stageSnapshot(Database& workingCopy, const fs::path& file, const std::string& saveId) {
    const fs::path beside = temporaryBeside(file);
    Result<DocumentState> saved = writeSnapshot(workingCopy, beside, saveId);
    if (!saved) {
        removeDatabase(beside);
        return std::move(saved).error();
    }
    Result<StagedFile> staged = StagedFile::adopt(beside, file);
    if (!staged) return std::move(staged).error();
    return StagedSnapshot{std::move(*staged), std::move(*saved)};
}

} // namespace

Result<SavedSnapshot> saveSnapshot(Database& workingCopy, const fs::path& file, std::span<StagedFile> outputs) {
    if (Result<void> allowed = mayBeReplaced(file); !allowed) return std::move(allowed).error();
    const std::string saveId = newSaveId();
    if (Result<void> noted = run(workingCopy, "UPDATE document SET next_save_id = ?", BlobView{saveId}); !noted)
        return std::move(noted).error();
    Result<StagedSnapshot> saved = stageSnapshot(workingCopy, file, saveId);
    if (!saved) return std::move(saved).error();
    Result<fs::path> kept = keepEarlierFormat(file);
    if (!kept) return std::move(kept).error();
    if (Result<void> placed = placeTogether(saved->file, outputs); !placed) {
        std::error_code ignored;
        if (!kept->empty()) fs::remove(*kept, ignored);
        return std::move(placed).error();
    }
    // If this fails, the file is saved all the same, and `next_save_id` lets the next open detect that.
    static_cast<void>(run(workingCopy,
                          "UPDATE document SET save_id = ?, next_save_id = x'', revision = ?, saved_changes = ?",
                          BlobView{saveId}, saved->state.revision, saved->state.changes));
    return SavedSnapshot{saved->state.changes, std::move(*kept)};
}

Result<StagedFile> saveCopy(Database& workingCopy, const fs::path& file) {
    if (Result<void> allowed = mayBeReplaced(file); !allowed) return std::move(allowed).error();
    Result<StagedSnapshot> saved = stageSnapshot(workingCopy, file, newSaveId());
    if (!saved) return std::move(saved).error();
    if (Result<void> placed = saved->file.putInPlace(); !placed) return std::move(placed).error();
    return std::move(saved->file);
}

} // namespace burin
