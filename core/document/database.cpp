// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/document/database.h"

#include "core/base/file.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <limits>
#include <sqlite3.h>
#include <unistd.h>

namespace burin {

namespace {

constexpr int spanInstructions = 100'000; // between two checks of the budget: about a millisecond
// Measured: a check of a complete file with the smallest rows takes a third of an instruction per byte.
constexpr std::uint64_t leastBudget = 50'000'000, budgetPerByte = 16;
constexpr int busyMilliseconds = 5000; // the recorder and the document write to the same working copy alternately

bool isDiskFull(int systemError) {
    return systemError == ENOSPC || systemError == EDQUOT || systemError == EFBIG;
}

bool isReading(int extendedCode) {
    return extendedCode == SQLITE_IOERR_READ || extendedCode == SQLITE_IOERR_SHORT_READ;
}

ErrorCode codeOf(int sqliteCode, int systemError) {
    switch (sqliteCode & 0xff) {
    case SQLITE_FULL:
        return ErrorCode::diskFull;
    case SQLITE_READONLY:
    case SQLITE_PERM:
    case SQLITE_AUTH:
    case SQLITE_CANTOPEN:
        return isDiskFull(systemError) ? ErrorCode::diskFull : ErrorCode::fileNotWritable;
    case SQLITE_IOERR:
        if (isDiskFull(systemError)) return ErrorCode::diskFull;
        return isReading(sqliteCode) ? ErrorCode::fileNotReadable : ErrorCode::fileNotWritable;
    case SQLITE_NOTADB:
        return ErrorCode::projectNotBurin;
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
    case SQLITE_PROTOCOL:
        return ErrorCode::projectInUse;
    case SQLITE_NOMEM:
    case SQLITE_TOOBIG:
        return ErrorCode::outOfMemory;
    // Our statements are constant: if a table or a column is missing, the file is not a valid project.
    case SQLITE_ERROR:
    case SQLITE_CORRUPT:
    case SQLITE_FORMAT:
    case SQLITE_MISMATCH:
    case SQLITE_CONSTRAINT:
    case SQLITE_INTERRUPT: // over its budget
        return ErrorCode::fileDamaged;
    default:
        return ErrorCode::internalFault;
    }
}

/// If SQLite can't create a file next to the database, it tries to open it without creating it, and keeps the error of
/// that attempt: no such file. Creating another file fails for the real reason, unless that has passed (0).
int reasonBehind(sqlite3* handle) {
    const char* const file = handle != nullptr ? sqlite3_db_filename(handle, "main") : nullptr;
    if (file == nullptr || ::access(file, F_OK) != 0) return ENOENT;
    const std::filesystem::path probe = temporaryBeside(file);
    const int descriptor = ::open(probe.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0) return errno;
    ::close(descriptor);
    ::unlink(probe.c_str());
    return 0;
}

/// SQLite keeps the system's reason only if a call fails at once, not if the last step of a statement fails; errno then
/// still holds it, as it was cleared before the call.
int systemErrorOf(sqlite3* handle, int code, int lastError) {
    const int primary = code & 0xff;
    if (primary != SQLITE_IOERR && primary != SQLITE_CANTOPEN) return 0;
    const int kept = handle != nullptr ? sqlite3_system_errno(handle) : 0;
    const int reason = kept != 0 ? kept : lastError;
    return primary == SQLITE_CANTOPEN && reason == ENOENT ? reasonBehind(handle) : reason;
}

void distrustSchema(sqlite3* handle) {
    // https://www.sqlite.org/security.html, "Untrusted SQLite Database Files"
    sqlite3_db_config(handle, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
    sqlite3_db_config(handle, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
    sqlite3_db_config(handle, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
    sqlite3_db_config(handle, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
    sqlite3_exec(handle, "PRAGMA cell_size_check = ON", nullptr, nullptr, nullptr);
}

/// https://www.sqlite.org/uri.html, "immutable": takes no lock and looks for no journal.
std::string unchangingUri(const std::filesystem::path& file) {
    std::string uri = "file:";
    for (const char character : file.native()) {
        if (character == '%' || character == '?' || character == '#') {
            constexpr std::string_view digits = "0123456789abcdef";
            const auto byte = static_cast<unsigned char>(character);
            uri.append(1, '%').append(1, digits[byte >> 4U]).append(1, digits[byte & 15U]);
        } else {
            uri += character;
        }
    }
    return uri + "?immutable=1";
}

const char* notNull(std::string_view bytes) {
    return bytes.data() != nullptr ? bytes.data() : "";
}

} // namespace

namespace {

std::uint64_t sizeOf(sqlite3* handle) {
    std::uint64_t bytes = 0;
    int inMemory = 0, highest = 0;
    if (sqlite3_db_status(handle, SQLITE_DBSTATUS_CACHE_USED, &inMemory, &highest, 0) == SQLITE_OK)
        bytes = static_cast<std::uint64_t>(inMemory);
    const char* const file = sqlite3_db_filename(handle, "main");
    if (file == nullptr || *file == '\0') return bytes;
    for (const char* suffix : {"", "-wal"}) {
        std::error_code missing;
        const std::uintmax_t size = std::filesystem::file_size(std::string(file) + suffix, missing);
        if (!missing) bytes += size;
    }
    return bytes;
}

} // namespace

int Database::Connection::lookAtBudget(void* connection) noexcept {
    auto& self = *static_cast<Connection*>(connection);
    const std::uint64_t done = ++self.spans * spanInstructions;
    // The file grows during the work, so its size is determined only when it is needed.
    return done > leastBudget && done > leastBudget + budgetPerByte * sizeOf(self.handle) ? 1 : 0;
}

Database::Connection::~Connection() {
    sqlite3_close(handle);
}

Error Database::errorOf(const Connection& connection, int code) {
    const int systemError = systemErrorOf(connection.handle, code, errno);
    std::string detail = sqlite3_errstr(code);
    if (connection.handle != nullptr) detail = sqlite3_errmsg(connection.handle);
    if (systemError != 0) detail.append(" (").append(std::strerror(systemError)).append(")");
    return {codeOf(code, systemError), connection.subject, {}, std::move(detail)};
}

Error Database::error(int code) const {
    return errorOf(*connection_, code);
}

Result<Database> Database::openNamed(const char* name, int flags, std::string subject) {
    sqlite3* handle = nullptr;
    const int code = sqlite3_open_v2(name, &handle, flags | SQLITE_OPEN_NOMUTEX | SQLITE_OPEN_EXRESCODE, nullptr);
    auto connection = std::make_unique<Connection>(handle, std::move(subject));
    if (code != SQLITE_OK) return errorOf(*connection, code);
    sqlite3_busy_timeout(handle, busyMilliseconds);
    sqlite3_progress_handler(handle, spanInstructions, &Connection::lookAtBudget, connection.get());
    distrustSchema(handle);
    return Database(std::move(connection));
}

Result<Database> Database::open(const std::filesystem::path& file, std::string subject, Access access) {
    switch (access) {
    case Access::read:
        return openNamed(file.c_str(), SQLITE_OPEN_READONLY, std::move(subject));
    case Access::write:
        return openNamed(file.c_str(), SQLITE_OPEN_READWRITE | SQLITE_OPEN_NOFOLLOW, std::move(subject));
    case Access::create:
        return openNamed(file.c_str(), SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_NOFOLLOW,
                         std::move(subject));
    case Access::readJournal:
        break;
    case Access::readUnchanging:
        return openNamed(unchangingUri(file).c_str(), SQLITE_OPEN_READONLY | SQLITE_OPEN_URI, std::move(subject));
    }
    Result<Database> database =
        openNamed(file.c_str(), SQLITE_OPEN_READWRITE | SQLITE_OPEN_NOFOLLOW, std::move(subject));
    if (!database) return database;
    sqlite3_db_config(database->connection_->handle, SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, 1, nullptr);
    // In this mode the index of the journal is kept in memory instead of in a separate file.
    for (const char* setting : {"PRAGMA locking_mode = EXCLUSIVE", "PRAGMA query_only = ON"})
        if (Result<void> done = database->execute(setting); !done) return std::move(done).error();
    return database;
}

Result<Database> Database::inMemory(std::string subject) {
    return openNamed(":memory:", SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, std::move(subject));
}

Result<void> Database::execute(const char* sql) {
    errno = 0;
    connection_->spans = 0;
    const int code = sqlite3_exec(connection_->handle, sql, nullptr, nullptr, nullptr);
    if (code != SQLITE_OK) return error(code);
    return {};
}

Result<std::int64_t> Database::integer(const char* sql) {
    Result<Statement> statement = Statement::prepare(*this, sql);
    if (!statement) return std::move(statement).error();
    Result<bool> row = statement->step();
    if (!row) return std::move(row).error();
    if (!*row) return Error{ErrorCode::fileDamaged, subject(), {}, std::string("no row: ") + sql};
    return statement->integer(0);
}

Result<void> Database::quickCheck() {
    Result<Statement> statement = Statement::prepare(*this, "PRAGMA quick_check(1)");
    if (!statement) return std::move(statement).error();
    Result<bool> row = statement->step();
    if (!row) return std::move(row).error();
    if (!*row || statement->text(0) != "ok")
        return Error{ErrorCode::fileDamaged, subject(), {}, std::string(*row ? statement->text(0) : "no answer")};
    return {};
}

Result<void> copyDatabase(Database& from, Database& to) {
    sqlite3_backup* backup = sqlite3_backup_init(to.connection_->handle, "main", from.connection_->handle, "main");
    if (backup == nullptr) return to.error(sqlite3_errcode(to.connection_->handle));
    // One step for all pages: it holds one read snapshot, so that writes to the source never make it start again.
    const int stepped = sqlite3_backup_step(backup, -1);
    const int finished = sqlite3_backup_finish(backup);
    if (finished != SQLITE_OK) return to.error(finished);
    if (stepped != SQLITE_DONE) return to.error(stepped); // busy, which finish does not report as an error
    return {};
}

void Statement::Finalize::operator()(sqlite3_stmt* statement) const noexcept {
    sqlite3_finalize(statement);
}

Result<Statement> Statement::prepare(Database& database, std::string_view sql) {
    sqlite3_stmt* statement = nullptr;
    database.connection_->spans = 0;
    const int code =
        sqlite3_prepare_v2(database.connection_->handle, sql.data(), static_cast<int>(sql.size()), &statement, nullptr);
    if (code != SQLITE_OK) return database.error(code);
    return Statement(*database.connection_, statement);
}

Result<void> Statement::outcome(int code) const {
    if (code != SQLITE_OK) return Database::errorOf(*connection_, code);
    return {};
}

void Statement::reset() {
    connection_->spans = 0;
    sqlite3_reset(statement_.get());
} // repeats the error of the last step, which was already reported

Result<bool> Statement::step() {
    errno = 0;
    const int code = sqlite3_step(statement_.get());
    if (code == SQLITE_ROW) return true;
    if (code == SQLITE_DONE) return false;
    Error fault = Database::errorOf(*connection_, code);
    reset();
    return fault;
}

Result<void> Statement::run() {
    for (;;) {
        Result<bool> row = step();
        if (!row) return std::move(row).error();
        if (!*row) break;
    }
    return outcome(sqlite3_reset(statement_.get()));
}

std::int64_t Statement::integer(int column) const {
    return sqlite3_column_int64(statement_.get(), column);
}

double Statement::real(int column) const {
    return isNull(column) ? std::numeric_limits<double>::quiet_NaN() : sqlite3_column_double(statement_.get(), column);
}

std::string_view Statement::text(int column) const {
    const unsigned char* characters = sqlite3_column_text(statement_.get(), column);
    const int size = sqlite3_column_bytes(statement_.get(), column);
    if (characters == nullptr) return {};
    return {reinterpret_cast<const char*>(characters), static_cast<std::size_t>(size)};
}

std::string_view Statement::blob(int column) const {
    const void* bytes = sqlite3_column_blob(statement_.get(), column);
    const int size = sqlite3_column_bytes(statement_.get(), column);
    if (bytes == nullptr) return {};
    return {static_cast<const char*>(bytes), static_cast<std::size_t>(size)};
}

bool Statement::isNull(int column) const {
    return type(column) == SQLITE_NULL;
}
int Statement::type(int column) const {
    return sqlite3_column_type(statement_.get(), column);
}
int Statement::columns() const {
    return sqlite3_column_count(statement_.get());
}

int Statement::bindOne(int index, std::int64_t value) {
    return sqlite3_bind_int64(statement_.get(), index, value);
}
int Statement::bindOne(int index, double value) {
    return sqlite3_bind_double(statement_.get(), index, value);
}
int Statement::bindOne(int index, std::string_view value) {
    return sqlite3_bind_text64(statement_.get(), index, notNull(value), value.size(), nullptr, SQLITE_UTF8);
}
int Statement::bindOne(int index, BlobView value) {
    return sqlite3_bind_blob64(statement_.get(), index, notNull(value.bytes), value.bytes.size(), nullptr);
}
int Statement::bindOne(int index, std::nullopt_t) {
    return sqlite3_bind_null(statement_.get(), index);
}

Result<Transaction> Transaction::begin(Database& database, Kind kind) {
    if (Result<void> begun = database.execute(kind == Kind::write ? "BEGIN IMMEDIATE" : "BEGIN"); !begun)
        return std::move(begun).error();
    return Transaction(database);
}

Transaction::~Transaction() {
    // After a full disk SQLite may have rolled back by itself; the second ROLLBACK then fails harmlessly.
    if (database_ != nullptr) static_cast<void>(database_->execute("ROLLBACK"));
}

Result<void> Transaction::commit() {
    Result<void> committed = database_->execute("COMMIT");
    if (committed) database_ = nullptr;
    return committed;
}

} // namespace burin
