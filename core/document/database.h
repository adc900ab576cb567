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

/// One connection to an SQLite file. Every fault comes back as an Error that names `subject`, the file that the user
/// knows, even where the connection is to a working copy of it. Thread: one at a time. Statements must end before it.
class Database {
public:
    enum class Access : std::uint8_t {
        read,
        write,
        create,
        readJournal,   ///< a WAL database that nobody else has open; nothing is written, nor made beside it
        readUnchanging ///< a database that nobody can change meanwhile; its journal is not looked for
    };
    /// Foreign triggers, views and functions of the schema are never run: a project may come from anybody. A statement
    /// that works far longer than the file's size explains ends with fileDamaged.
    /// Errors: as `error` maps SQLite's codes.
    static Result<Database> open(const std::filesystem::path& file, std::string subject, Access access);
    /// An empty one that nobody else sees.
    static Result<Database> inMemory(std::string subject);

    /// Runs statements that give no rows, or whose rows don't matter.
    Result<void> execute(const char* sql);
    /// First column of the first row. Errors: fileDamaged when there is no row.
    Result<std::int64_t> integer(const char* sql);
    /// Fails with fileDamaged and SQLite's finding as detail.
    Result<void> quickCheck();

    /// What SQLite's result `code` means: diskFull, fileNotWritable, fileNotReadable, projectInUse, projectNotBurin,
    /// fileDamaged, outOfMemory; internalFault for what our own statements must never cause.
    Error error(int code) const;
    const std::string& subject() const noexcept { return connection_->subject; }

private:
    friend class Statement;
    friend Result<void> copyDatabase(Database& from, Database& to);
    struct Connection {
        sqlite3* handle = nullptr;
        std::string subject;
        std::uint64_t spans = 0; ///< of SQLite's instructions that the present statement has run
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

/// All pages of `from`, as they are at this moment, to `to`, through SQLite's backup interface. Other connections to
/// `from` may write meanwhile.
Result<void> copyDatabase(Database& from, Database& to);

/// Bytes to bind as a blob.
struct BlobView {
    std::string_view bytes;
};

/// A prepared statement. Texts and blobs that were bound must live until the row or the end was reached.
class Statement {
public:
    /// Errors: as Database::error maps SQLite's codes, here and below. The database outlives the statement.
    static Result<Statement> prepare(Database& database, std::string_view sql);

    /// Forgets what an earlier use left behind and binds the parameters, first to last.
    template <class... Values>
    Result<void> bind(const Values&... values) {
        reset();
        int index = 0;
        int code = 0; // SQLITE_OK
        ((code = code != 0 ? code : bindOne(++index, values)), ...);
        return outcome(code);
    }
    /// True: a row is there to be read. False: the statement has ended.
    Result<bool> step();
    /// Steps to the end.
    Result<void> run();

    // Columns of the row, counted from 0. Views end with the next step.
    std::int64_t integer(int column) const;
    double real(int column) const; ///< NaN where NULL stands: SQLite keeps no NaN
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

/// Prepares, binds and runs a statement that gives no rows.
template <class... Values>
Result<void> run(Database& database, std::string_view sql, const Values&... values) {
    Result<Statement> statement = Statement::prepare(database, sql);
    if (!statement) return std::move(statement).error();
    if (Result<void> bound = statement->bind(values...); !bound) return bound;
    return statement->run();
}

/// All or nothing: rolls back unless it was committed.
class Transaction {
public:
    enum class Kind : std::uint8_t { read, write };
    /// A write waits for other writers of the same file here, not half-way.
    static Result<Transaction> begin(Database& database, Kind kind);
    ~Transaction();
    Transaction(Transaction&& other) noexcept : database_(std::exchange(other.database_, nullptr)) {}
    Transaction& operator=(Transaction&&) = delete;
    /// What was written is on the disk when this returns, in a database that flushes its commits. Once. Errors: as
    /// Database::error; nothing is written then.
    Result<void> commit();

private:
    explicit Transaction(Database& database) : database_(&database) {}
    Database* database_;
};

} // namespace burin
