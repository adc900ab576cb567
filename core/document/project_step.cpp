// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/document/project_step.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <new>
#include <sqlite3.h>
#include <utility>

namespace burin {

namespace {

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
    leaveFile();
}

void ProjectStep::append(std::string_view bytes) {
    if (inMemory() && !staysInMemory_ && memory_.size() + bytes.size() > mostInMemory) moveToFile();
    if (!inMemory() && !store(bytes)) moveToMemory();
    if (inMemory()) memory_.append(bytes);
    size_ += bytes.size();
}

/// Appends to the file. @return whether it could be written
bool ProjectStep::store(std::string_view bytes) {
    parts_.reserve(parts_.size() + 1); // so that no part is lost
    const FilePart part = file_->append(bytes);
    if (part.size != bytes.size()) return false;
    if (!parts_.empty() && parts_.back().at + parts_.back().size == part.at)
        parts_.back().size += part.size;
    else
        parts_.push_back(part);
    return true;
}

void ProjectStep::moveToFile() {
    file_ = StepFile::in(beside_);
    if (file_ != nullptr && store(memory_)) {
        memory_ = {};
        return;
    }
    staysInMemory_ = true;
    leaveFile();
}

/// The disk is full.
void ProjectStep::moveToMemory() {
    std::string all(size_, '\0');
    if (read(0, all) != size_) throw std::bad_alloc(); // a step with a gap must never be reverted
    memory_ = std::move(all);
    staysInMemory_ = true;
    leaveFile();
}

void ProjectStep::leaveFile() noexcept {
    for (auto part = parts_.rbegin(); part != parts_.rend(); ++part) file_->release(*part);
    parts_.clear();
    file_.reset();
}

std::size_t ProjectStep::read(std::uint64_t from, std::span<char> into) const {
    const std::uint64_t left = from < size_ ? size_ - from : 0;
    const std::size_t count = std::min<std::uint64_t>(left, into.size());
    if (inMemory()) return memory_.copy(into.data(), count, from);
    std::size_t done = 0;
    std::uint64_t start = 0; // of the part in the step
    for (const FilePart& part : parts_) {
        const std::uint64_t at = from + done;
        if (done < count && at < start + part.size) {
            const std::size_t here = std::min<std::uint64_t>(count - done, start + part.size - at);
            const std::size_t read = file_->read(part.at + (at - start), into.subspan(done, here));
            done += read;
            if (read < here) break;
        }
        start += part.size;
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
DELETE FROM path_source WHERE generated IS NOT NULL AND generated NOT IN (SELECT id FROM generated);
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
