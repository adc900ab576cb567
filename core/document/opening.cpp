// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/document/opening.h"

#include "core/base/file.h"
#include "core/base/guarded.h"
#include "core/document/companions.h"
#include "core/document/saving.h"
#include "core/document/schema.h"

#include <array>
#include <cerrno>
#include <chrono>
#include <fcntl.h>
#include <optional>
#include <system_error>
#include <thread>
#include <unistd.h>
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

/// The user's file, opened for reading and found complete.
struct SavedFile {
    Database database;
    DocumentState state;
};

/// Must be the first check of a file that may come from an untrusted source.
Result<void> checkForm(Database& database) {
    if (Result<void> ours = checkIdentity(database); !ours) return ours;
    return checkSchema(database);
}

Result<void> checkDigest(Database& database, const DocumentState& state) {
    if (!state.digest) return {};
    const Result<std::int64_t> found = contentDigest(database);
    if (!found) return found.error();
    if (*found != *state.digest) return Error{ErrorCode::fileDamaged, database.subject(), {}, "digest differs"};
    return {};
}

/// A second connection to the same save of a file; empty: there is none, or the file was replaced meanwhile.
std::optional<Database> openAgain(const fs::path& file, const DocumentState& state) {
    Result<Database> database = Database::open(file, file.string(), Database::Access::read);
    if (!database || !checkForm(*database)) return std::nullopt;
    const Result<DocumentState> now = documentState(*database);
    if (!now || now->saveId != state.saveId || now->changes != state.changes) return std::nullopt;
    return std::move(*database);
}

/// Both checks read the whole file: those of a long recording go on together.
Result<void> checkContent(const fs::path& file, Database& database, const DocumentState& state) {
    constexpr std::uintmax_t large = 16 << 20; // bytes
    std::error_code unknown;
    std::optional<Database> second;
    if (state.digest && fs::file_size(file, unknown) >= large && !unknown) second = openAgain(file, state);
    if (!second) {
        if (Result<void> sound = database.quickCheck(); !sound) return sound;
        return checkDigest(database, state);
    }
    Result<void> same;
    {
        const std::jthread other([&] { same = guarded("project", [&] { return checkDigest(*second, state); }); });
        if (Result<void> sound = database.quickCheck(); !sound) return sound;
    }
    return same;
}

/// Bytes 18 and 19 of a database: the format versions required for writing and reading it, 1 (journal) or 2 (WAL).
Result<void> checkHeader(const fs::path& file) {
    Result<std::ifstream> stream = openFileStream(file);
    if (!stream) return std::move(stream).error();
    std::array<char, 20> head{};
    if (!stream->read(head.data(), head.size())) return {}; // too short: SQLite will identify it
    const auto form = [&](std::size_t place) { return static_cast<unsigned char>(head[place]); };
    if (form(18) > 2 || form(19) > 2) return Error{ErrorCode::fileDamaged, file.string(), "header", {}};
    return {};
}

Result<SavedFile> openSaved(const fs::path& file) {
    std::error_code ignored;
    if (fs::is_directory(file, ignored)) return Error{ErrorCode::projectNotBurin, file.string(), {}, "a folder"};
    if (isEmptyFile(file)) return Error{ErrorCode::fileEmpty, file.string(), {}, {}};
    if (fs::exists(file, ignored) && !fs::is_regular_file(file, ignored))
        return Error{ErrorCode::projectNotBurin, file.string(), {}, "no regular file"};
    Result<Database> database = Database::open(file, file.string(), Database::Access::read);
    if (!database) {
        Error error = std::move(database).error();
        if (error.code == ErrorCode::fileNotWritable) error.code = ErrorCode::fileNotReadable; // "can't open"
        return error;
    }
    if (Result<void> ours = checkForm(*database); !ours) return std::move(ours).error();
    if (Result<void> known = checkHeader(file); !known) return std::move(known).error();
    Result<DocumentState> state = documentState(*database);
    if (!state) return std::move(state).error();
    if (Result<void> sound = checkContent(file, *database, *state); !sound) return std::move(sound).error();
    return SavedFile{std::move(*database), std::move(*state)};
}

/// How to handle a working copy that an earlier run left behind.
enum class Leftover : std::uint8_t { none, holdsNothingNew, belongsToFile, belongsToAnother, unreadable };

/// Whether an error means that a file's content can't be used, and not a temporary fault.
bool isDamage(const Error& error) {
    return error.code == ErrorCode::fileDamaged || error.code == ErrorCode::projectNotBurin;
}

/// Errors: temporary faults, in which case the copy is not judged.
Result<Leftover> judge(const WorkingCopy& copy, const DocumentState& saved) {
    if (!copy.exists()) return Leftover::none;
    if (copy.hasNoContent()) return Leftover::holdsNothingNew;
    const Result<DocumentState> left = copy.state();
    if (!left && isDamage(left.error())) return Leftover::unreadable;
    if (!left) return left.error();
    if (left->saveId == saved.saveId) return left->unsaved() ? Leftover::belongsToFile : Leftover::holdsNothingNew;
    if (left->nextSaveId == saved.saveId) // killed between the rename of a save and its note in the copy
        return left->changes != saved.changes ? Leftover::belongsToFile : Leftover::holdsNothingNew;
    return left->unsaved() ? Leftover::belongsToAnother : Leftover::holdsNothingNew;
}

/// Sets the copy's state to be based on `saved`, with no save in progress. Null: its content is in no file.
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
        return standOn(empty, &saved.state);
    });
}

Result<Database> adopt(const WorkingCopy& copy, const DocumentState* saved) {
    Result<Database> database = copy.connect();
    if (!database) return database;
    if (Result<void> ours = checkForm(*database); !ours) return std::move(ours).error();
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

/// Connects to a copy that was just made from the file, and removes it again if it can't be used.
Result<Database> connectFresh(WorkingCopy& copy) {
    Result<Database> database = copy.connect();
    if (database)
        if (Result<void> current = upgrade(*database); !current) database = std::move(current).error();
    if (!database) copy.abandon();
    return database;
}

Result<OpenedCopy> startFrom(std::shared_ptr<WorkingCopy> copy, SavedFile& saved) {
    if (Result<void> placed = placeFresh(*copy, saved); !placed) return std::move(placed).error();
    Result<Database> database = connectFresh(*copy);
    if (!database) return std::move(database).error();
    return OpenedCopy{std::move(copy), std::move(*database), false, {}};
}

/// Returns the opened database for reading only: as a copy in memory if it is not to be kept open, or if it is of an
/// older version, which is then upgraded.
Result<OpenedCopy> forReading(Database database, bool recovered, bool inMemory) {
    const Result<std::int64_t> version = database.integer("PRAGMA user_version");
    if (!version) return version.error();
    if (inMemory || *version != projectVersion) {
        Result<Database> memory = Database::inMemory(database.subject());
        if (!memory) return std::move(memory).error();
        if (Result<void> copied = copyDatabase(database, *memory); !copied) return std::move(copied).error();
        if (Result<void> current = upgrade(*memory); !current) return std::move(current).error();
        database = std::move(*memory);
    }
    if (Result<void> closed = database.execute("PRAGMA query_only = ON"); !closed) return std::move(closed).error();
    return OpenedCopy{nullptr, std::move(database), recovered, {}};
}

Result<OpenedCopy> savedForReading(const fs::path& file) {
    Result<SavedFile> saved = openSaved(file);
    if (!saved) return std::move(saved).error();
    return forReading(std::move(saved->database), false, false);
}

/// Reads leftover unsaved work without changing it, into memory, so that nobody has to wait for its reader.
Result<OpenedCopy> leftForReading(const WorkingCopy& copy) {
    Result<Database> database = copy.connectForReading();
    if (!database) return std::move(database).error();
    if (Result<void> ours = checkForm(*database); !ours) return std::move(ours).error();
    if (Result<void> sound = database->quickCheck(); !sound) return std::move(sound).error();
    return forReading(std::move(*database), true, true);
}

/// Waits while other processes only read leftover work, which takes them moments. Errors: as WorkingCopy::lock.
Result<std::shared_ptr<WorkingCopy>> lockForReading(const fs::path& file) {
    constexpr int attempts = 100;
    for (int attempt = 1;; ++attempt) {
        Result<std::shared_ptr<WorkingCopy>> locked = WorkingCopy::lock(file, WorkingCopy::Purpose::reading);
        const bool waits = !locked && locked.error().code == ErrorCode::projectInUse &&
                           WorkingCopy::isReading(locked.error()) && attempt < attempts;
        if (!waits) return locked;
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
}

/// A copy of another version must never be judged, let alone moved, by this version.
Result<void> checkLeftoverVersion(const WorkingCopy& copy) {
    if (!copy.exists()) return {};
    Result<Database> database = copy.connectForReading();
    if (!database) return {};
    if (Result<void> ours = checkForm(*database); !ours && ours.error().code == ErrorCode::fileFromNewerBurin)
        return ours;
    return {};
}

/// Returns the save id of the current `file`; empty if none can be determined.
Result<std::string> standingSave(const fs::path& file) {
    if (!stands(file) || isEmptyFile(file)) return std::string();
    std::error_code ignored;
    if (!fs::is_regular_file(file, ignored))
        return Error{ErrorCode::projectNotBurin, file.string(), {}, "no regular file"};
    Result<Database> database = Database::open(file, file.string(), Database::Access::read);
    if (!database) return Error{ErrorCode::projectNotBurin, file.string(), {}, database.error().detail};
    const Result<std::int64_t> application = database->integer("PRAGMA application_id");
    if (!application || *application != projectApplicationId)
        return Error{ErrorCode::projectNotBurin, file.string(), {}, {}};
    if (!checkForm(*database)) return std::string();
    Result<DocumentState> state = documentState(*database);
    return state ? state->saveId : std::string();
}

Result<OpenedCopy> openBeside(std::shared_ptr<WorkingCopy> copy, SavedFile& saved) {
    const Result<Leftover> judged = judge(*copy, saved.state);
    if (!judged) return judged.error();
    const Leftover leftover = *judged;
    if (leftover == Leftover::belongsToFile) {
        Result<OpenedCopy> taken = takeUp(copy, &saved.state);
        // A copy that can't be read completely is moved aside below; the saved file is still complete.
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

/// Makes room for a new working copy: an existing one is removed, or moved aside if it was not saved. Returns its new
/// name.
Result<fs::path> makeRoom(WorkingCopy& copy) {
    copy.removeAbandonedParts();
    if (!copy.exists() || copy.hasNoContent()) return fs::path();
    const Result<DocumentState> left = copy.state();
    if (!left && !isDamage(left.error())) return left.error();
    return !left || left->unsaved() ? copy.setAside() : Result<fs::path>(fs::path());
}

/// Errors: fileNotFound, fileNotReadable.
Result<void> checkReached(const fs::path& file) {
    std::error_code unreached;
    static_cast<void>(fs::status(file, unreached));
    if (unreached && !stands(WorkingCopy::pathBeside(file)) && !stands(Companions::unshortened(file).working))
        return readError(file, unreached.value());
    return {};
}

/// Whether files can't be created next to the file for lack of permissions, which is permanent, and not for a temporary
/// fault.
bool isProtected(const fs::path& file) {
    return ::faccessat(AT_FDCWD, file.parent_path().c_str(), W_OK, AT_EACCESS) != 0 &&
           (errno == EACCES || errno == EROFS || errno == EPERM);
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
        state.saveId = *standing; // so that after a crash of this session it is known that this very file was to be
                                  // replaced
        return setDocumentState(empty, state);
    });
    if (!placed) return placed.error();
    Result<Database> database = connectFresh(**copy);
    if (!database) return std::move(database).error();
    return OpenedCopy{std::move(*copy), std::move(*database), false, std::move(*keptAside)};
}

Result<OpenedCopy> saveUnderAnotherName(Database& from, const fs::path& file) {
    Result<std::shared_ptr<WorkingCopy>> copy = WorkingCopy::lock(file);
    if (!copy) return std::move(copy).error();
    if (const Result<std::string> standing = standingSave(file); !standing) return standing.error();
    Result<fs::path> keptAside = makeRoom(**copy);
    if (!keptAside) return std::move(keptAside).error();
    Result<StagedFile> saved = saveCopy(from, file);
    if (!saved) return std::move(saved).error();
    Result<OpenedCopy> opened = [&]() -> Result<OpenedCopy> {
        Result<SavedFile> whole = openSaved(file);
        if (!whole) return std::move(whole).error();
        return startFrom(std::move(*copy), *whole);
    }();
    if (opened)
        opened->keptAside = std::move(*keptAside);
    else
        saved->takeBack();
    return opened;
}

Result<OpenedCopy> openWorkingCopy(const fs::path& file) {
    if (const Result<void> reached = checkReached(file); !reached) return reached.error();
    Result<std::shared_ptr<WorkingCopy>> locked = WorkingCopy::lock(file);
    if (!locked && locked.error().code == ErrorCode::fileNotWritable && stands(file) && isProtected(file))
        return savedForReading(file);
    if (!locked) return std::move(locked).error();
    std::shared_ptr<WorkingCopy> copy = std::move(*locked);
    copy->removeAbandonedParts();
    if (Result<void> readable = checkLeftoverVersion(*copy); !readable) return std::move(readable).error();

    if (!stands(file)) return takeUp(std::move(copy), nullptr);
    Result<SavedFile> saved = openSaved(file);
    if (saved) return openBeside(std::move(copy), *saved);
    // If the file was damaged later, this does not affect the copy, which was made while it was complete.
    const bool salvage = saved.error().code == ErrorCode::fileDamaged && copy->exists() && copy->state();
    if (!salvage) return std::move(saved).error();
    return takeUp(std::move(copy), nullptr);
}

Result<OpenedCopy> openForReading(const fs::path& file) {
    if (const Result<void> reached = checkReached(file); !reached) return reached.error();
    // A save replaces the complete file by another one, so only leftover work needs a lock.
    const bool left = stands(WorkingCopy::pathBeside(file)) || stands(Companions::unshortened(file).working);
    if (stands(file) && !left) return savedForReading(file);
    Result<std::shared_ptr<WorkingCopy>> locked = lockForReading(file);
    // While another process works on the project, its last save is shown; if that process only reads leftover work, the
    // saved file would be the wrong content.
    const bool inUse = !locked && locked.error().code == ErrorCode::projectInUse;
    if (inUse && stands(file) && !WorkingCopy::isReading(locked.error())) return savedForReading(file);
    if (!locked && !inUse && stands(file) && isProtected(file)) return savedForReading(file);
    std::shared_ptr<WorkingCopy> copy = locked                                       ? std::move(*locked)
                                        : locked.error().code == ErrorCode::diskFull ? WorkingCopy::withoutLock(file)
                                                                                     : nullptr;
    if (!copy) return std::move(locked).error();
    if (locked) copy->removeAbandonedParts();
    if (Result<void> readable = checkLeftoverVersion(*copy); !readable) return std::move(readable).error();

    if (!stands(file)) return leftForReading(*copy);
    Result<SavedFile> saved = openSaved(file);
    if (!saved) {
        const bool salvage = saved.error().code == ErrorCode::fileDamaged && copy->exists() && copy->state();
        return salvage ? leftForReading(*copy) : std::move(saved).error();
    }
    const Result<Leftover> leftover = judge(*copy, saved->state);
    if (!leftover) return leftover.error();
    if (*leftover == Leftover::belongsToFile) {
        Result<OpenedCopy> unsaved = leftForReading(*copy);
        if (unsaved || !isDamage(unsaved.error())) return unsaved;
    }
    if (*leftover == Leftover::holdsNothingNew) copy->abandon();
    return forReading(std::move(saved->database), false, false);
}

} // namespace burin
