// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/project_mutation.h"

#include <array>
#include <cstring>
#include <limits>
#include <memory>
#include <random>
#include <sqlite3.h>
#include <string>
#include <vector>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* bytes, std::size_t count, std::size_t most);

namespace burin::fuzz {

namespace {

using Connection = std::unique_ptr<sqlite3, decltype(&sqlite3_close)>;
using Statement = std::unique_ptr<sqlite3_stmt, decltype(&sqlite3_finalize)>;
using Random = std::minstd_rand;

constexpr std::array<const char*, 21> tables{
    "document", "model",           "body",          "import_note", "setup",        "obstacle",        "guide",
    "material", "path_edit",       "path_source",   "path",        "sample_chunk", "undone_stretch",  "take",
    "tool",     "milling_setting", "setup_setting", "program",     "generated",    "generated_chunk", "take_material"};
constexpr std::array numbers{0.0, -1.0, 1e-308, 1e6, 1e18, 1e308, std::numeric_limits<double>::infinity()};
constexpr std::array counts{std::int64_t{0},
                            std::int64_t{-1},
                            std::int64_t{16385},
                            std::int64_t{1} << 31,
                            std::int64_t{1} << 62,
                            std::numeric_limits<std::int64_t>::max(),
                            std::numeric_limits<std::int64_t>::min()};
constexpr std::size_t roomToGrow = 4096;

std::size_t below(std::size_t end, Random& random) {
    return std::uniform_int_distribution<std::size_t>(0, end - 1)(random);
}

Connection opened(const std::uint8_t* bytes, std::size_t count) {
    sqlite3* handle = nullptr;
    sqlite3_open(":memory:", &handle);
    Connection database(handle, &sqlite3_close);
    auto* const copy = static_cast<unsigned char*>(sqlite3_malloc64(count + 1));
    std::memcpy(copy, bytes, count);
    const auto size = static_cast<sqlite3_int64>(count);
    sqlite3_deserialize(handle, "main", copy, size, size,
                        SQLITE_DESERIALIZE_FREEONCLOSE | SQLITE_DESERIALIZE_RESIZEABLE);
    sqlite3_db_config(handle, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
    sqlite3_db_config(handle, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
    return database;
}

/// Null if the database no longer has such a table or column; SQLite's functions accept that.
Statement prepared(sqlite3* database, const std::string& sql) {
    sqlite3_stmt* statement = nullptr;
    sqlite3_prepare_v2(database, sql.c_str(), -1, &statement, nullptr);
    return {statement, &sqlite3_finalize};
}

std::vector<std::string> columnsOf(sqlite3* database, const std::string& table) {
    std::vector<std::string> names;
    const Statement rows = prepared(database, "SELECT name FROM pragma_table_info('" + table + "')");
    while (sqlite3_step(rows.get()) == SQLITE_ROW)
        names.emplace_back(reinterpret_cast<const char*>(sqlite3_column_text(rows.get(), 0)));
    return names;
}

std::string mutated(const void* bytes, int count) {
    const auto size = static_cast<std::size_t>(count);
    std::string changed(size + roomToGrow, '\0');
    if (size > 0) std::memcpy(changed.data(), bytes, size);
    changed.resize(LLVMFuzzerMutate(reinterpret_cast<std::uint8_t*>(changed.data()), size, changed.size()));
    return changed;
}

/// Binds another value of the type of `old`.
void bindAnother(sqlite3_stmt* statement, sqlite3_value* old, Random& random) {
    const int type = sqlite3_value_type(old);
    if (type == SQLITE_INTEGER) {
        sqlite3_bind_int64(statement, 1, counts[below(counts.size(), random)]);
    } else if (type == SQLITE_FLOAT || type == SQLITE_NULL) {
        sqlite3_bind_double(statement, 1, numbers[below(numbers.size(), random)]);
    } else {
        const std::string changed = mutated(sqlite3_value_blob(old), sqlite3_value_bytes(old));
        const auto size = static_cast<int>(changed.size());
        if (type == SQLITE_TEXT)
            sqlite3_bind_text(statement, 1, changed.data(), size, SQLITE_TRANSIENT);
        else
            sqlite3_bind_blob(statement, 1, changed.data(), size, SQLITE_TRANSIENT);
    }
}

/// Changes one value of one row, deletes a row, or duplicates it.
void changeRow(sqlite3* database, Random& random) {
    const std::string table = tables[below(tables.size(), random)];
    const std::vector<std::string> columns = columnsOf(database, table);
    if (columns.empty()) return;
    const std::string& column = columns[below(columns.size(), random)];
    const Statement row =
        prepared(database, "SELECT rowid, " + column + " FROM " + table + " LIMIT 1 OFFSET " +
                               std::to_string(below(1000, random)) + " % (SELECT max(count(*), 1) FROM " + table + ")");
    if (sqlite3_step(row.get()) != SQLITE_ROW) return;
    const std::string place = " WHERE rowid = " + std::to_string(sqlite3_column_int64(row.get(), 0));
    std::string sql = "UPDATE OR IGNORE " + table + " SET " + column + " = ?" + place;
    const std::size_t kind = below(8, random);
    if (kind == 0) sql = "DELETE FROM " + table + place;
    if (kind == 1) {
        sql = "INSERT OR IGNORE INTO " + table + " SELECT NULL"; // SQLite chooses an unused ID or position
        for (std::size_t i = 1; i < columns.size(); ++i) sql += ", " + columns[i];
        sql += " FROM " + table + place;
    }
    const Statement change = prepared(database, sql);
    if (kind > 1) bindAnother(change.get(), sqlite3_column_value(row.get(), 1), random);
    sqlite3_step(change.get());
}

} // namespace

std::size_t mutateProject(std::uint8_t* bytes, std::size_t count, std::size_t most, unsigned seed) {
    Random random(seed);
    if (below(8, random) == 0) return LLVMFuzzerMutate(bytes, count, most);
    const Connection database = opened(bytes, count);
    for (std::size_t changes = 1 + below(3, random); changes > 0; --changes) changeRow(database.get(), random);
    sqlite3_exec(database.get(), "UPDATE document SET digest = NULL", nullptr, nullptr, nullptr);
    sqlite3_int64 size = 0;
    const std::unique_ptr<unsigned char, decltype(&sqlite3_free)> changed(
        sqlite3_serialize(database.get(), "main", &size, 0), &sqlite3_free);
    if (!changed || size <= 0 || static_cast<std::size_t>(size) > most) return LLVMFuzzerMutate(bytes, count, most);
    std::memcpy(bytes, changed.get(), static_cast<std::size_t>(size));
    return static_cast<std::size_t>(size);
}

} // namespace burin::fuzz
