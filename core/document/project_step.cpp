// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/document/project_step.h"

#include "core/base/file.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <new>
#include <sqlite3.h>
#include <unistd.h>
#include <utility>

namespace burin {

namespace {

/// Opens a file that has no name. Returns a negative number where that is not possible.
int openNameless(const std::filesystem::path& beside) {
    const int file = ::open(beside.parent_path().c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
    if (file >= 0) return file;
    const std::filesystem::path named = temporaryBeside(beside); // the file system has no nameless files
    const int other = ::open(named.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    if (other >= 0) ::unlink(named.c_str());
    return other;
}

bool writeAt(int file, std::uint64_t at, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::pwrite(file, bytes.data(), bytes.size(), static_cast<off_t>(at));
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return false;
        at += static_cast<std::uint64_t>(written);
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
}

int isRecorded(void*, const char* table) noexcept {
    return std::strcmp(table, "document") != 0 && std::strcmp(table, "kept_workpiece") != 0 ? 1 : 0;
}

int appendToStep(void* step, const void* bytes, int size) noexcept {
    try {
        static_cast<ProjectStep*>(step)->append({static_cast<const char*>(bytes), static_cast<std::size_t>(size)});
        return SQLITE_OK;
    } catch (const std::bad_alloc&) {
        return SQLITE_NOMEM;
    }
}

struct StepReader {
    const ProjectStep& step;
    std::uint64_t at = 0;
};

int readFromStep(void* context, void* bytes, int* size) noexcept {
    auto& reader = *static_cast<StepReader*>(context);
    const std::size_t read = reader.step.read(reader.at, {static_cast<char*>(bytes), static_cast<std::size_t>(*size)});
    reader.at += read;
    *size = static_cast<int>(read);
    return reader.at == reader.step.size() || read > 0 ? SQLITE_OK : SQLITE_IOERR_READ;
}

/// Later changes of the same rows are overwritten; rows that are gone need not be removed.
int settleConflict(void*, int kind, sqlite3_changeset_iter*) noexcept {
    switch (kind) {
    case SQLITE_CHANGESET_DATA:
    case SQLITE_CHANGESET_CONFLICT:
        return SQLITE_CHANGESET_REPLACE;
    case SQLITE_CHANGESET_NOTFOUND:
    case SQLITE_CHANGESET_FOREIGN_KEY: // `removeOrphans` follows
        return SQLITE_CHANGESET_OMIT;
    default:
        return SQLITE_CHANGESET_ABORT;
    }
}

} // namespace

ProjectStep::ProjectStep(std::filesystem::path beside) : beside_(std::move(beside)) {}

ProjectStep::~ProjectStep() {
    if (file_ >= 0) ::close(file_);
}

void ProjectStep::append(std::string_view bytes) {
    if (inMemory() && !staysInMemory_ && memory_.size() + bytes.size() > mostInMemory) moveToFile();
    if (!inMemory() && !writeAt(file_, size_, bytes)) moveToMemory();
    if (inMemory()) memory_.append(bytes);
    size_ += bytes.size();
}

void ProjectStep::moveToFile() {
    file_ = openNameless(beside_);
    if (file_ >= 0 && writeAt(file_, 0, memory_)) {
        memory_ = {};
        return;
    }
    staysInMemory_ = true;
    if (file_ >= 0) ::close(std::exchange(file_, -1));
}

/// The disk is full.
void ProjectStep::moveToMemory() {
    std::string all(size_, '\0');
    read(0, all);
    memory_ = std::move(all);
    staysInMemory_ = true;
    ::close(std::exchange(file_, -1));
}

std::size_t ProjectStep::read(std::uint64_t from, std::span<char> into) const {
    const std::uint64_t left = from < size_ ? size_ - from : 0;
    const std::size_t count = std::min<std::uint64_t>(left, into.size());
    if (inMemory()) return memory_.copy(into.data(), count, from);
    std::size_t done = 0;
    while (done < count) {
        const ssize_t read = ::pread(file_, into.data() + done, count - done, static_cast<off_t>(from + done));
        if (read < 0 && errno == EINTR) continue;
        if (read <= 0) break;
        done += static_cast<std::size_t>(read);
    }
    return done;
}

void StepRecorder::Delete::operator()(sqlite3_session* session) const noexcept {
    sqlite3session_delete(session);
}

Result<StepRecorder> StepRecorder::begin(Database& database) {
    sqlite3_session* session = nullptr;
    if (const int code = sqlite3session_create(database.connection_->handle, "main", &session); code != SQLITE_OK)
        return database.error(code);
    StepRecorder recorder(database, session);
    sqlite3session_table_filter(session, &isRecorded, nullptr);
    if (const int code = sqlite3session_attach(session, nullptr); code != SQLITE_OK) return database.error(code);
    return recorder;
}

Result<std::shared_ptr<const ProjectStep>> StepRecorder::end(const std::filesystem::path& beside) {
    const auto step = std::make_shared<ProjectStep>(beside);
    const int code = sqlite3session_changeset_strm(session_.get(), &appendToStep, step.get());
    session_.reset();
    if (code != SQLITE_OK) return database_->error(code);
    return step->size() > 0 ? std::shared_ptr<const ProjectStep>(step) : nullptr;
}

Result<void> revertRows(Database& database, const ProjectStep& step) {
    StepReader reader{step};
    database.connection_->spans = 0;
    errno = 0;
    const int code =
        sqlite3changeset_apply_v2_strm(database.connection_->handle, &readFromStep, &reader, nullptr, &settleConflict,
                                       nullptr, nullptr, nullptr, SQLITE_CHANGESETAPPLY_INVERT);
    return code == SQLITE_OK ? Result<void>() : Result<void>(database.error(code));
}

Result<void> removeOrphans(Database& database) {
    return database.execute(R"sql(
UPDATE take SET removed = 1 WHERE removed = 0 AND setup NOT IN (SELECT id FROM setup);
DELETE FROM path_edit WHERE path NOT IN (SELECT path.id FROM path JOIN setup ON setup.id = path.setup);
DELETE FROM path_source WHERE path NOT IN (SELECT path.id FROM path JOIN setup ON setup.id = path.setup);
DELETE FROM path WHERE setup NOT IN (SELECT id FROM setup);
DELETE FROM generated_chunk WHERE generated IN (SELECT id FROM generated WHERE setup NOT IN (SELECT id FROM setup));
DELETE FROM generated WHERE setup NOT IN (SELECT id FROM setup);
DELETE FROM program WHERE setup NOT IN (SELECT id FROM setup);
DELETE FROM kept_workpiece WHERE setup NOT IN (SELECT id FROM setup);
DELETE FROM stock_volume WHERE setup NOT IN (SELECT id FROM setup);
DELETE FROM marker WHERE setup NOT IN (SELECT id FROM setup);
DELETE FROM obstacle WHERE setup NOT IN (SELECT id FROM setup);
DELETE FROM guide WHERE setup NOT IN (SELECT id FROM setup);
DELETE FROM setup_setting WHERE setup NOT IN (SELECT id FROM setup);
)sql");
}

} // namespace burin
