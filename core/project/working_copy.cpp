// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/project/working_copy.h"

#include "core/base/file.h"

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

fs::path hiddenBeside(const fs::path& file, std::string_view ending) {
    return file.parent_path() / ("." + file.filename().string() + std::string(ending));
}

fs::path lockBeside(const fs::path& file) {
    return hiddenBeside(file, ".lock");
}

fs::path withEnding(const fs::path& file, const char* ending) {
    fs::path result = file;
    return result += ending;
}

void removeQuietly(const fs::path& file) {
    std::error_code ignored;
    fs::remove(file, ignored);
}

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

void writeOwner(int descriptor) {
    const std::string owner = "process " + std::to_string(::getpid());
    // Only for the message that another process shows; the lock holds without it.
    if (::ftruncate(descriptor, 0) != 0 || ::pwrite(descriptor, owner.data(), owner.size(), 0) < 0) return;
}

fs::path freeName(const fs::path& file) {
    for (int number = 1;; ++number) {
        const std::string name = file.stem().string() + ".kept-" + std::to_string(number) + file.extension().string();
        std::error_code ignored;
        if (!fs::exists(file.parent_path() / name, ignored)) return file.parent_path() / name;
    }
}

/// Turns a copy into a saved project, so that it opens as any other.
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

Result<std::shared_ptr<WorkingCopy>> WorkingCopy::lock(const fs::path& file) {
    const fs::path path = lockBeside(file);
    for (;;) {
        const int descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
        if (descriptor < 0) return writeError(file, errno);
        if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
            const int reason = errno;
            Error error = reason == EWOULDBLOCK ? Error{ErrorCode::projectInUse, file.string(), {}, ownerIn(descriptor)}
                                                : writeError(file, reason);
            ::close(descriptor);
            return error;
        }
        // Its last owner may have removed the name between our open and our lock: then it locks nothing.
        if (sameFile(descriptor, path)) {
            writeOwner(descriptor);
            return std::shared_ptr<WorkingCopy>(new WorkingCopy(file, descriptor));
        }
        ::close(descriptor);
    }
}

WorkingCopy::~WorkingCopy() {
    if (exists()) {
        const std::optional<DocumentState> left = abandoned_ ? std::nullopt : state();
        if (abandoned_ || (left && !left->unsaved())) discard();
    }
    ::unlink(lockBeside(file_).c_str()); // while it is still ours
    ::close(lock_);
}

fs::path WorkingCopy::pathBeside(const fs::path& file) {
    return hiddenBeside(file, ".working");
}

bool WorkingCopy::exists() const {
    std::error_code ignored;
    return fs::exists(path(), ignored);
}

Result<Database> WorkingCopy::connect() const {
    Result<Database> database = Database::open(path(), file_.string(), Database::Access::write);
    if (!database) return database;
    for (const char* setting : {"PRAGMA journal_mode = WAL", "PRAGMA synchronous = FULL", "PRAGMA foreign_keys = ON"})
        if (Result<void> done = database->execute(setting); !done) return std::move(done).error();
    return database;
}

std::optional<DocumentState> WorkingCopy::state() const {
    Result<Database> database = Database::open(path(), file_.string(), Database::Access::write);
    if (!database) return std::nullopt;
    Result<DocumentState> state = documentState(*database);
    if (!state) return std::nullopt;
    return std::move(*state);
}

Result<void> WorkingCopy::place(const std::function<Result<void>(Database& empty)>& fill) {
    const fs::path fresh = withEnding(path(), ".new");
    discard();
    removeQuietly(fresh);
    const auto filled = [&]() -> Result<void> {
        Result<Database> database = Database::open(fresh, file_.string(), Database::Access::create);
        if (!database) return std::move(database).error();
        for (const char* setting : {"PRAGMA journal_mode = MEMORY", "PRAGMA synchronous = OFF"})
            if (Result<void> done = database->execute(setting); !done) return done;
        return fill(*database);
    }();
    if (!filled) {
        removeQuietly(fresh);
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
        // Where this fails the copy goes aside as it is, with its journal: nothing of it is lost.
        if (database) static_cast<void>(finishAsProject(*database));
    }
    removeQuietly(withEnding(path(), "-shm"));
    ::rename(withEnding(path(), "-wal").c_str(), withEnding(aside, "-wal").c_str());
    if (::rename(path().c_str(), aside.c_str()) != 0) return writeError(file_, errno);
    return aside;
}

void WorkingCopy::discard() {
    // The journal last would be a danger: SQLite would play it back into the next copy.
    for (const char* ending : {"-wal", "-shm", ""}) removeQuietly(withEnding(path(), ending));
}

void WorkingCopy::removeAbandonedParts() const {
    removeQuietly(withEnding(path(), ".new"));
    const std::string start = "." + file_.filename().string() + ".";
    std::error_code failed;
    for (fs::directory_iterator entry(file_.parent_path(), failed), end; !failed && entry != end;
         entry.increment(failed)) {
        const std::string name = entry->path().filename().string();
        const bool part = name.starts_with(start) && name.ends_with(".part") &&
                          name.find_first_not_of("0123456789-", start.size()) == name.size() - 5;
        if (part) removeQuietly(entry->path());
    }
}

} // namespace burin
