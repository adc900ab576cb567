// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/project/saving.h"

#include "core/base/file.h"
#include "core/project/document_state.h"

#include <cerrno>
#include <string>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace burin {

namespace fs = std::filesystem;

namespace {

/// A removed recording leaves free pages behind; a file that is mostly those is worth writing anew.
Result<void> dropFreePages(Database& snapshot) {
    const Result<std::int64_t> free = snapshot.integer("PRAGMA freelist_count");
    if (!free) return free.error();
    const Result<std::int64_t> all = snapshot.integer("PRAGMA page_count");
    if (!all) return all.error();
    if (*free * 4 < *all) return {};
    return snapshot.execute("VACUUM");
}

/// Writes the snapshot; its state as a saved file comes back.
Result<DocumentState> writeSnapshot(Database& workingCopy, const fs::path& beside, const std::string& saveId) {
    Result<Database> snapshot = Database::open(beside, workingCopy.subject(), Database::Access::create);
    if (!snapshot) return std::move(snapshot).error();
    // No journal and no flush: what doesn't get to its end is thrown away, and the end is flushed before the rename.
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

void keepRights(const fs::path& beside, const fs::path& file) {
    struct stat standing {};
    if (::stat(file.c_str(), &standing) == 0 && ::chmod(beside.c_str(), standing.st_mode & 07777) != 0) return;
}

/// Nothing that protects a file from being written is overcome by the rename.
Result<void> mayBeReplaced(const fs::path& file) {
    if (::access(file.c_str(), W_OK) != 0 && errno != ENOENT) return writeError(file, errno);
    return {};
}

Result<DocumentState> writeOver(Database& workingCopy, const fs::path& file, const std::string& saveId) {
    const fs::path beside = temporaryBeside(file);
    Result<DocumentState> saved = writeSnapshot(workingCopy, beside, saveId);
    if (!saved) {
        std::error_code ignored;
        fs::remove(beside, ignored);
        return saved;
    }
    keepRights(beside, file);
    if (Result<void> replaced = replaceFile(beside, file); !replaced) return std::move(replaced).error();
    return saved;
}

} // namespace

Result<void> saveSnapshot(Database& workingCopy, const fs::path& file) {
    if (Result<void> allowed = mayBeReplaced(file); !allowed) return allowed;
    const std::string saveId = newSaveId();
    if (Result<void> noted = run(workingCopy, "UPDATE document SET next_save_id = ?", BlobView{saveId}); !noted)
        return noted;
    const Result<DocumentState> saved = writeOver(workingCopy, file, saveId);
    if (!saved) return saved.error();
    // Should this fail, the file is saved all the same, and `next_save_id` lets the next open see it.
    static_cast<void>(run(workingCopy,
                          "UPDATE document SET save_id = ?, next_save_id = x'', revision = ?, saved_changes = ?",
                          BlobView{saveId}, saved->revision, saved->changes));
    return {};
}

Result<void> saveCopy(Database& workingCopy, const fs::path& file) {
    if (Result<void> allowed = mayBeReplaced(file); !allowed) return allowed;
    const Result<DocumentState> saved = writeOver(workingCopy, file, newSaveId());
    return saved ? Result<void>() : Result<void>(saved.error());
}

} // namespace burin
