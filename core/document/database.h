// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"

#include <concepts>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace burin {

class ProjectStep;

/// One connection to an SQLite file. Every fault is returned as an Error that names `subject`, the file known to the
/// user, even if the connection is to a working copy of it. Not thread-safe: one thread at a time. Statements must be
/// destroyed before it.
class Database {
public:
    enum class Access : std::uint8_t {
        read,
        write,
        create,
        readJournal,   ///< a WAL database that nobody else has open; writes nothing, and creates no files in its folder
        readUnchanging ///< a database that nobody can change meanwhile; does not look for its journal
    };
    /// Foreign triggers, views and functions of the schema are never run, as a project may come from an untrusted
    /// source. A statement that runs far longer than the file's size explains ends with fileDamaged.
    /// Errors: as `error` maps SQLite's codes.
    static Result<Database> open(const std::filesystem::path& file, std::string subject, Access access);
    /// Opens an empty database that is private to this connection.
    static Result<Database> inMemory(std::string subject);

    /// Runs statements that return no rows, or whose rows are not needed.
    Result<void> execute(const char* sql);
    /// Returns the first column of the first row. Errors: fileDamaged if there is no row.
    Result<std::int64_t> integer(const char* sql);
    /// Runs SQLite's quick check. Errors: fileDamaged, with SQLite's finding as detail.
    Result<void> quickCheck();

    /// Converts SQLite's result `code` into an error: diskFull, fileNotWritable, fileNotReadable, projectInUse,
    /// projectNotBurin, fileDamaged, outOfMemory; internalFault for codes that our own statements must never cause.
    Error error(int code) const;
    const std::string& subject() const noexcept { return connection_->subject; }

private:
    friend class Statement;
    friend class StepRecorder;
    friend Result<void> revertRows(Database& database, const ProjectStep& step);
    friend Result<void> copyDatabase(Database& from, Database& to);
    struct Connection {
        sqlite3* handle = nullptr;
        std::string subject;
        std::uint64_t spans = 0; ///< number of spans of SQLite's instructions that the present statement has run
        Connection(sqlite3* opened, std::string name) : handle(opened), subject(std::move(name)) {}
        ~Connection();
        static int lookAtBudget(void* connection) noexcept;
        Connection(const Connection&) = delete;
        Connection& operator=(const Connection&) = delete;
    };
    explicit Database(std::unique_ptr<Connection> connection) : connection_(std::move(connection)) {}
    static Result<Database> openNamed(const char* name, int flags, std::string subject);
    static Error errorOf(const Connection& connection, int code);

    std::unique_ptr<Connection> connection_;
};

/// Copies all pages of `from`, as they are at this moment, to `to`, through SQLite's backup interface. Other
/// connections may write to `from` meanwhile.
Result<void> copyDatabase(Database& from, Database& to);

/// Bytes to bind as a blob.
struct BlobView {
    std::string_view bytes;
};

/// A prepared statement. Bound texts and blobs must remain valid until the row or the end was reached.
class Statement {
public:
    /// Errors: as Database::error maps SQLite's codes, here and below. The database must outlive the statement.
    static Result<Statement> prepare(Database& database, std::string_view sql);

    /// Resets the statement and binds the parameters, first to last.
    template <class... Values>
    Result<void> bind(const Values&... values) {
        reset();
        int index = 0;
        int code = 0; // SQLITE_OK
        ((code = code != 0 ? code : bindOne(++index, values)), ...);
        return outcome(code);
    }
    /// Returns true if a row can be read, false if the statement has ended.
    Result<bool> step();
    /// Executes the statement to its end.
    Result<void> run();

    // Columns of the row, counted from 0. Returned views are valid until the next step.
    std::int64_t integer(int column) const;
    double real(int column) const; ///< NaN for NULL: SQLite stores no NaN
    std::string_view text(int column) const;
    std::string_view blob(int column) const;
    bool isNull(int column) const;
    int type(int column) const; ///< SQLITE_INTEGER, …
    int columns() const;

private:
    struct Finalize {
        void operator()(sqlite3_stmt* statement) const noexcept;
    };
    Statement(Database::Connection& connection, sqlite3_stmt* statement)
        : connection_(&connection), statement_(statement) {}

    void reset();
    Result<void> outcome(int code) const;
    int bindOne(int index, std::int64_t value);
    int bindOne(int index, double value);
    int bindOne(int index, std::string_view value);
    int bindOne(int index, BlobView value);
    int bindOne(int index, std::nullopt_t);
    template <std::integral Integer>
    int bindOne(int index, Integer value) {
        return bindOne(index, static_cast<std::int64_t>(value));
    }
    int bindOne(int index, const std::string& value) { return bindOne(index, std::string_view(value)); }
    template <class Value>
    int bindOne(int index, const std::optional<Value>& value) {
        return value ? bindOne(index, *value) : bindOne(index, std::nullopt);
    }

    Database::Connection* connection_;
    std::unique_ptr<sqlite3_stmt, Finalize> statement_;
};

/// Prepares, binds and runs a statement that returns no rows.
template <class... Values>
Result<void> run(Database& database, std::string_view sql, const Values&... values) {
    Result<Statement> statement = Statement::prepare(database, sql);
    if (!statement) return std::move(statement).error();
    if (Result<void> bound = statement->bind(values...); !bound) return bound;
    return statement->run();
}

/// A transaction that rolls back in its destructor unless it was committed.
class Transaction {
public:
    enum class Kind : std::uint8_t { read, write };
    /// A write transaction waits for other writers of the same file here, not half-way.
    static Result<Transaction> begin(Database& database, Kind kind);
    ~Transaction();
    Transaction(Transaction&& other) noexcept : database_(std::exchange(other.database_, nullptr)) {}
    Transaction& operator=(Transaction&&) = delete;
    /// When this returns, the changes are on the disk, in a database that flushes its commits. Call once. Errors: as
    /// Database::error; nothing is written then.
    Result<void> commit();

private:
    explicit Transaction(Database& database) : database_(&database) {}
    Database* database_;
};

} // namespace burin
