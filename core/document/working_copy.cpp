// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/document/working_copy.h"

#include "core/base/file.h"
#include "core/base/staged_file.h"
#include "core/document/companions.h"
#include "core/document/schema.h"

#include <array>
#include <cerrno>
#include <fcntl.h>
#include <string>
#include <string_view>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace burin {

namespace fs = std::filesystem;

namespace {

bool sameFile(int descriptor, const fs::path& path) {
    struct stat opened {};
    struct stat named {};
    return ::fstat(descriptor, &opened) == 0 && ::stat(path.c_str(), &named) == 0 && opened.st_ino == named.st_ino &&
           opened.st_dev == named.st_dev;
}

std::string ownerIn(int descriptor) {
    std::array<char, 32> text{};
    const ssize_t size = ::pread(descriptor, text.data(), text.size(), 0);
    return size > 0 ? std::string(text.data(), static_cast<std::size_t>(size)) : std::string("another process");
}

constexpr std::string_view reading = ", reading";

void writeOwner(int descriptor, WorkingCopy::Purpose purpose) {
    std::string owner = "process " + std::to_string(::getpid());
    if (purpose == WorkingCopy::Purpose::reading) owner += reading;
    // Only for the message of another process; the lock is valid without it.
    if (::ftruncate(descriptor, 0) != 0 || ::pwrite(descriptor, owner.data(), owner.size(), 0) < 0) return;
}

fs::path freeName(const fs::path& file) {
    for (int number = 1;; ++number) {
        fs::path name = labelledBeside(file, "kept-" + std::to_string(number));
        std::error_code ignored;
        if (!fs::exists(fs::symlink_status(name, ignored))) return name;
    }
}

/// Opens a lock file, creating it if there is none. Negative: errno holds the reason.
int openLock(const fs::path& path) {
    for (;;) {
        int descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
        if (descriptor >= 0 || (errno != EEXIST && errno != EINTR)) return descriptor;
        descriptor = ::open(path.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
        if (descriptor < 0 && (errno == ENOENT || errno == EINTR)) continue; // its owner has just removed it
        return descriptor;
    }
}

/// Whether the open file is one that Burin created: regular, and without another name, under which it could be another
/// file of the user that would be truncated.
bool isOurs(int descriptor) {
    struct stat opened {};
    return ::fstat(descriptor, &opened) == 0 && S_ISREG(opened.st_mode) && opened.st_nlink <= 1;
}

bool isRegular(const fs::path& path) {
    struct stat named {};
    return ::lstat(path.c_str(), &named) == 0 && S_ISREG(named.st_mode);
}

Error notOurs(const fs::path& file, const fs::path& companion) {
    return {ErrorCode::fileNotWritable, file.string(), {}, companion.filename().string() + " is in the way"};
}

/// Creates a new file for SQLite, so that no existing file is used, and the reason is known if there is no space for
/// it.
int makeFile(const fs::path& path) {
    const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (descriptor < 0) return errno == EEXIST ? 0 : errno;
    ::close(descriptor);
    return 0;
}

/// Locks the lock file of a file name. Errors: as WorkingCopy::lock.
Result<int> lockedDescriptor(const fs::path& file, const fs::path& path) {
    for (;;) {
        const int descriptor = openLock(path);
        if (descriptor < 0) return errno == ELOOP ? notOurs(file, path) : writeError(file, errno);
        if (!isOurs(descriptor)) {
            ::close(descriptor);
            return notOurs(file, path);
        }
        if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
            const int reason = errno;
            Error error = reason == EWOULDBLOCK ? Error{ErrorCode::projectInUse, file.string(), {}, ownerIn(descriptor)}
                                                : writeError(file, reason);
            ::close(descriptor);
            return error;
        }
        // Its last owner may have removed the file between our open and our lock: then the lock has no effect.
        if (sameFile(descriptor, path)) return descriptor;
        ::close(descriptor);
    }
}

/// Gives `file` the additional name `other`, or renames it if the file system has no links. Returns 0, or the errno
/// value.
int linkOrRename(const fs::path& file, const fs::path& other) {
    if (::link(file.c_str(), other.c_str()) == 0) return 0;
    return ::rename(file.c_str(), other.c_str()) == 0 ? 0 : errno;
}

/// Turns a copy into a saved project, so that it can be opened like any other.
Result<void> finishAsProject(Database& database) {
    Result<DocumentState> state = documentState(database);
    if (!state) return std::move(state).error();
    state->saveId = newSaveId();
    state->nextSaveId.clear();
    state->savedChanges = state->changes;
    state->digest.reset();
    if (Result<void> done = setDocumentState(database, *state); !done) return done;
    return database.execute("PRAGMA journal_mode = DELETE");
}

} // namespace

WorkingCopy::WorkingCopy(fs::path file, int lockDescriptor) : file_(std::move(file)), lock_(lockDescriptor) {}

bool WorkingCopy::isReading(const Error& inUse) {
    return inUse.detail.ends_with(reading);
}

Result<std::shared_ptr<WorkingCopy>> WorkingCopy::lock(const fs::path& file, Purpose purpose) {
    const Result<int> descriptor = lockedDescriptor(file, Companions::of(file).lock);
    if (!descriptor) return descriptor.error();
    std::shared_ptr<WorkingCopy> copy(new WorkingCopy(file, *descriptor));
    if (Result<void> ours = copy->takeOldNames(); !ours) return std::move(ours).error();
    writeOwner(copy->lock_, purpose);
    std::error_code none;
    if (fs::exists(fs::symlink_status(copy->path(), none)) && !isRegular(copy->path()))
        return notOurs(file, copy->path());
    return copy;
}

std::shared_ptr<WorkingCopy> WorkingCopy::withoutLock(const fs::path& file) {
    std::error_code none;
    for (const Companions& names : {Companions::of(file), Companions::unshortened(file)})
        if (fs::exists(fs::symlink_status(names.lock, none))) return nullptr;
    return std::shared_ptr<WorkingCopy>(new WorkingCopy(file, -1));
}

/// A copy of an older Burin under a longer name is respected while that is running, and taken over when it has ended.
Result<void> WorkingCopy::takeOldNames() {
    const Companions names = Companions::of(file_), old = Companions::unshortened(file_);
    if (old.lock == names.lock) return {};
    if (isRegular(old.lock)) {
        const Result<int> descriptor = lockedDescriptor(file_, old.lock);
        if (!descriptor) return descriptor.error();
        oldLock_ = *descriptor;
    }
    if (!isRegular(old.working) || exists()) return {};
    for (const char* ending : {"-wal", ""}) // the journal first: it is useless without its database
        if (isRegular(withEnding(old.working, ending)))
            if (const int reason = linkOrRename(withEnding(old.working, ending), withEnding(names.working, ending));
                reason != 0)
                return writeError(file_, reason);
    removeDatabase(old.working);
    return {};
}

WorkingCopy::~WorkingCopy() {
    if (lock_ < 0) return;
    if (exists()) {
        const bool saved = !abandoned_ && [&] {
            const Result<DocumentState> left = state();
            return left && !left->unsaved();
        }();
        if (abandoned_ || saved) discard();
    }
    ::unlink(Companions::of(file_).lock.c_str()); // while we still hold it
    ::close(lock_);
    if (oldLock_ < 0) return;
    ::unlink(Companions::unshortened(file_).lock.c_str());
    ::close(oldLock_);
}

fs::path WorkingCopy::pathBeside(const fs::path& file) {
    return Companions::of(file).working;
}

bool WorkingCopy::exists() const {
    return isRegular(path());
}

bool WorkingCopy::hasNoContent() const {
    constexpr std::uintmax_t journalHead = 32; // bytes, before the first page
    std::error_code unknown, none;
    const std::uintmax_t size = fs::file_size(path(), unknown),
                         journal = fs::file_size(withEnding(path(), "-wal"), none);
    return !unknown && size == 0 && (none || journal <= journalHead);
}

Result<Database> WorkingCopy::connect() const {
    for (const char* ending : {"-wal", "-shm"})
        if (const int reason = makeFile(withEnding(path(), ending)); reason != 0) return writeError(file_, reason);
    Result<Database> database = Database::open(path(), file_.string(), Database::Access::write);
    if (!database) return database;
    for (const char* setting : {"PRAGMA journal_mode = WAL", "PRAGMA synchronous = FULL", "PRAGMA foreign_keys = ON"})
        if (Result<void> done = database->execute(setting); !done) return std::move(done).error();
    return database;
}

Result<Database> WorkingCopy::connectForReading() const {
    std::error_code none;
    const bool journal = fs::file_size(withEnding(path(), "-wal"), none) > 0 && !none;
    return Database::open(path(), file_.string(),
                          journal ? Database::Access::readJournal : Database::Access::readUnchanging);
}

Result<DocumentState> WorkingCopy::state() const {
    Result<Database> database = connectForReading();
    if (!database) return std::move(database).error();
    if (Result<void> ours = checkIdentity(*database); !ours) return std::move(ours).error();
    if (Result<void> known = checkSchema(*database); !known) return std::move(known).error();
    return documentState(*database);
}

Result<void> WorkingCopy::place(const std::function<Result<void>(Database& empty)>& fill) {
    const fs::path fresh = withEnding(path(), ".new");
    discard();
    removeDatabase(fresh);
    if (const int reason = makeFile(fresh); reason != 0) return writeError(file_, reason);
    const auto filled = [&]() -> Result<void> {
        Result<Database> database = Database::open(fresh, file_.string(), Database::Access::create);
        if (!database) return std::move(database).error();
        for (const char* setting : {"PRAGMA journal_mode = MEMORY", "PRAGMA synchronous = OFF"})
            if (Result<void> done = database->execute(setting); !done) return done;
        return fill(*database);
    }();
    if (!filled) {
        removeDatabase(fresh);
        return filled;
    }
    if (Result<void> placed = replaceFile(fresh, path()); !placed)
        return Error{placed.error().code, file_.string(), {}, placed.error().detail};
    return {};
}

Result<fs::path> WorkingCopy::setAside() {
    const fs::path aside = freeName(file_);
    {
        Result<Database> database = Database::open(path(), file_.string(), Database::Access::write);
        // If this fails, the copy is moved aside unchanged, with its journal: nothing is lost.
        if (database && checkIdentity(*database) && checkSchema(*database))
            static_cast<void>(finishAsProject(*database));
    }
    // Both files get both names before the old ones are removed, so that a kill in between loses nothing.
    const fs::path journal = withEnding(path(), "-wal"), journalAside = withEnding(aside, "-wal");
    const bool journalled = isRegular(journal);
    if (journalled)
        if (const int reason = linkOrRename(journal, journalAside); reason != 0) return writeError(file_, reason);
    if (const int reason = linkOrRename(path(), aside); reason != 0) {
        if (journalled && isRegular(journal)) ::unlink(journalAside.c_str());
        if (journalled && !isRegular(journal)) ::rename(journalAside.c_str(), journal.c_str());
        return writeError(file_, reason);
    }
    discard();
    return aside;
}

void WorkingCopy::discard() {
    removeDatabase(path());
}

void WorkingCopy::removeAbandonedParts() const {
    removeDatabase(withEnding(path(), ".new"));
    burin::removeAbandonedParts(file_);
}

} // namespace burin
