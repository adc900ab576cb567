// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/project/opening.h"

#include "core/base/file.h"
#include "core/project/saving.h"
#include "core/project/schema.h"

#include <optional>
#include <system_error>
#include <utility>

namespace burin {

namespace fs = std::filesystem;

namespace {

bool stands(const fs::path& file) {
    std::error_code ignored;
    return fs::exists(file, ignored);
}

bool isEmptyFile(const fs::path& file) {
    std::error_code failed;
    return fs::is_regular_file(file, failed) && fs::file_size(file, failed) == 0 && !failed;
}

/// The user's file, opened for reading and found whole.
struct SavedFile {
    Database database;
    DocumentState state;
};

Result<void> checkContent(Database& database, const DocumentState& state) {
    if (Result<void> sound = database.quickCheck(); !sound) return sound;
    if (!state.digest) return {};
    const Result<std::int64_t> found = contentDigest(database);
    if (!found) return found.error();
    if (*found != *state.digest) return Error{ErrorCode::fileDamaged, database.subject(), {}, "digest differs"};
    return {};
}

Result<SavedFile> openSaved(const fs::path& file) {
    std::error_code ignored;
    if (fs::is_directory(file, ignored)) return Error{ErrorCode::projectNotBurin, file.string(), {}, "a folder"};
    if (isEmptyFile(file)) return Error{ErrorCode::fileEmpty, file.string(), {}, {}};
    Result<Database> database = Database::open(file, file.string(), Database::Access::read);
    if (!database) {
        Error error = std::move(database).error();
        if (error.code == ErrorCode::fileNotWritable) error.code = ErrorCode::fileNotReadable; // "can't open"
        return error;
    }
    if (Result<void> ours = checkIdentity(*database); !ours) return std::move(ours).error();
    Result<DocumentState> state = documentState(*database);
    if (!state) return std::move(state).error();
    if (Result<void> sound = checkContent(*database, *state); !sound) return std::move(sound).error();
    return SavedFile{std::move(*database), std::move(*state)};
}

/// What to do with a working copy that an earlier run left behind.
enum class Leftover : std::uint8_t { none, holdsNothingNew, belongsToFile, belongsToAnother, unreadable };

Leftover judge(const WorkingCopy& copy, const DocumentState& saved) {
    if (!copy.exists()) return Leftover::none;
    const std::optional<DocumentState> left = copy.state();
    if (!left) return Leftover::unreadable;
    if (left->saveId == saved.saveId) return left->unsaved() ? Leftover::belongsToFile : Leftover::holdsNothingNew;
    if (left->nextSaveId == saved.saveId) // killed between the rename of a save and its note in the copy
        return left->changes != saved.changes ? Leftover::belongsToFile : Leftover::holdsNothingNew;
    return left->unsaved() ? Leftover::belongsToAnother : Leftover::holdsNothingNew;
}

/// Makes the copy say that it stands on `saved`, and that no save is under way. Null: no file holds what is in it.
Result<void> standOn(Database& copy, const DocumentState* saved) {
    Result<DocumentState> state = documentState(copy);
    if (!state) return std::move(state).error();
    if (saved == nullptr) {
        state->savedChanges = -1;
    } else if (state->saveId != saved->saveId) {
        state->saveId = saved->saveId;
        state->revision = saved->revision;
        state->savedChanges = saved->changes;
    }
    state->nextSaveId.clear();
    state->digest.reset();
    return setDocumentState(copy, *state);
}

Result<void> placeFresh(WorkingCopy& copy, SavedFile& saved) {
    return copy.place([&](Database& empty) -> Result<void> {
        if (Result<void> copied = copyDatabase(saved.database, empty); !copied) return copied;
        Result<void> noted = standOn(empty, &saved.state);
        // The folder took all pages: what forbids writing now is a header of a form that nobody writes.
        if (!noted && noted.error().code == ErrorCode::fileNotWritable)
            return Error{ErrorCode::fileDamaged, copy.file().string(), "header", noted.error().detail};
        return noted;
    });
}

Result<Database> adopt(const WorkingCopy& copy, const DocumentState* saved) {
    Result<Database> database = copy.connect();
    if (!database) return database;
    if (Result<void> ours = checkIdentity(*database); !ours) return std::move(ours).error();
    if (Result<void> sound = database->quickCheck(); !sound) return std::move(sound).error();
    if (Result<void> noted = standOn(*database, saved); !noted) return std::move(noted).error();
    return database;
}

Result<OpenedCopy> takeUp(std::shared_ptr<WorkingCopy> copy, const DocumentState* saved) {
    Result<Database> database = adopt(*copy, saved);
    if (!database) return std::move(database).error();
    if (Result<void> current = upgrade(*database); !current) return std::move(current).error();
    return OpenedCopy{std::move(copy), std::move(*database), true, {}};
}

Result<OpenedCopy> startFrom(std::shared_ptr<WorkingCopy> copy, SavedFile& saved) {
    if (Result<void> placed = placeFresh(*copy, saved); !placed) return std::move(placed).error();
    Result<Database> database = copy->connect();
    if (!database) return std::move(database).error();
    if (Result<void> current = upgrade(*database); !current) return std::move(current).error();
    return OpenedCopy{std::move(copy), std::move(*database), false, {}};
}

/// Without a right to write beside the file, a copy in memory serves reading.
Result<OpenedCopy> openForReading(const fs::path& file) {
    Result<SavedFile> saved = openSaved(file);
    if (!saved) return std::move(saved).error();
    Result<Database> memory = Database::inMemory(file.string());
    if (!memory) return std::move(memory).error();
    if (Result<void> copied = copyDatabase(saved->database, *memory); !copied) return std::move(copied).error();
    if (Result<void> current = upgrade(*memory); !current) return std::move(current).error();
    if (Result<void> closed = memory->execute("PRAGMA query_only = ON"); !closed) return std::move(closed).error();
    return OpenedCopy{nullptr, std::move(*memory), false, {}};
}

/// Another version's copy must never be judged, let alone moved, by this one.
Result<void> checkLeftoverVersion(const WorkingCopy& copy) {
    if (!copy.exists()) return {};
    Result<Database> database = Database::open(copy.path(), copy.file().string(), Database::Access::write);
    if (!database) return {};
    if (Result<void> ours = checkIdentity(*database); !ours && ours.error().code == ErrorCode::fileFromNewerBurin)
        return ours;
    return {};
}

/// Name of the save that stands at `file` now; empty: none that could be told.
Result<std::string> standingSave(const fs::path& file) {
    if (!stands(file) || isEmptyFile(file)) return std::string();
    Result<Database> database = Database::open(file, file.string(), Database::Access::read);
    if (!database) return Error{ErrorCode::projectNotBurin, file.string(), {}, database.error().detail};
    const Result<std::int64_t> application = database->integer("PRAGMA application_id");
    if (!application || *application != projectApplicationId)
        return Error{ErrorCode::projectNotBurin, file.string(), {}, {}};
    Result<DocumentState> state = documentState(*database);
    return state ? state->saveId : std::string();
}

Result<OpenedCopy> openBeside(std::shared_ptr<WorkingCopy> copy, SavedFile& saved) {
    const Leftover leftover = judge(*copy, saved.state);
    if (leftover == Leftover::belongsToFile) {
        Result<OpenedCopy> taken = takeUp(copy, &saved.state);
        // A copy that can't be read through goes aside below; the saved file is still whole.
        if (taken || taken.error().code != ErrorCode::fileDamaged) return taken;
    }
    fs::path keptAside;
    if (leftover != Leftover::none && leftover != Leftover::holdsNothingNew) {
        Result<fs::path> aside = copy->setAside();
        if (!aside) return std::move(aside).error();
        keptAside = std::move(*aside);
    }
    Result<OpenedCopy> opened = startFrom(std::move(copy), saved);
    if (opened) opened->keptAside = std::move(keptAside);
    return opened;
}

/// For a new working copy: what stands in its place goes, or aside where nobody saved it. The name that it got then.
Result<fs::path> makeRoom(WorkingCopy& copy) {
    copy.removeAbandonedParts();
    if (!copy.exists()) return fs::path();
    const std::optional<DocumentState> left = copy.state();
    return !left || left->unsaved() ? copy.setAside() : Result<fs::path>(fs::path());
}

} // namespace

Result<OpenedCopy> createWorkingCopy(const fs::path& file) {
    Result<std::shared_ptr<WorkingCopy>> copy = WorkingCopy::lock(file);
    if (!copy) return std::move(copy).error();
    const Result<std::string> standing = standingSave(file);
    if (!standing) return standing.error();
    Result<fs::path> keptAside = makeRoom(**copy);
    if (!keptAside) return std::move(keptAside).error();
    const Result<void> placed = (*copy)->place([&](Database& empty) -> Result<void> {
        if (Result<void> made = createSchema(empty); !made) return made;
        DocumentState state;
        state.saveId = *standing; // so that a killed session finds that it was to replace this very file
        return setDocumentState(empty, state);
    });
    if (!placed) return placed.error();
    Result<Database> database = (*copy)->connect();
    if (!database) return std::move(database).error();
    return OpenedCopy{std::move(*copy), std::move(*database), false, std::move(*keptAside)};
}

Result<OpenedCopy> saveUnderAnotherName(Database& from, const fs::path& file) {
    Result<std::shared_ptr<WorkingCopy>> copy = WorkingCopy::lock(file);
    if (!copy) return std::move(copy).error();
    if (const Result<std::string> standing = standingSave(file); !standing) return standing.error();
    Result<fs::path> keptAside = makeRoom(**copy);
    if (!keptAside) return std::move(keptAside).error();
    if (Result<void> saved = saveCopy(from, file); !saved) return std::move(saved).error();
    Result<SavedFile> whole = openSaved(file);
    if (!whole) return std::move(whole).error();
    Result<OpenedCopy> opened = startFrom(std::move(*copy), *whole);
    if (opened) opened->keptAside = std::move(*keptAside);
    return opened;
}

Result<OpenedCopy> openWorkingCopy(const fs::path& file) {
    std::error_code unreached;
    static_cast<void>(fs::status(file, unreached));
    if (unreached && !stands(WorkingCopy::pathBeside(file))) return readError(file, unreached.value());
    Result<std::shared_ptr<WorkingCopy>> locked = WorkingCopy::lock(file);
    if (!locked && locked.error().code == ErrorCode::fileNotWritable && stands(file)) return openForReading(file);
    if (!locked) return std::move(locked).error();
    std::shared_ptr<WorkingCopy> copy = std::move(*locked);
    copy->removeAbandonedParts();
    if (Result<void> readable = checkLeftoverVersion(*copy); !readable) return std::move(readable).error();

    if (!stands(file)) return takeUp(std::move(copy), nullptr);
    Result<SavedFile> saved = openSaved(file);
    if (saved) return openBeside(std::move(copy), *saved);
    // A file that was damaged since doesn't matter to the copy that was made of it when it was whole.
    const bool salvage = saved.error().code == ErrorCode::fileDamaged && copy->state().has_value();
    if (!salvage) return std::move(saved).error();
    return takeUp(std::move(copy), nullptr);
}

} // namespace burin
