// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/document/digest.h"

#include <bit>
#include <sqlite3.h>

namespace burin {

namespace {

void addValue(const Statement& row, int column, Digest& digest) {
    const int type = row.type(column);
    digest.add(static_cast<std::uint64_t>(type));
    if (type == SQLITE_INTEGER)
        digest.add(static_cast<std::uint64_t>(row.integer(column)));
    else if (type == SQLITE_FLOAT)
        digest.add(std::bit_cast<std::uint64_t>(row.real(column)));
    else
        digest.add(row.blob(column));
}

} // namespace

Result<void> addRows(Database& database, const std::string& query, Digest& digest) {
    Result<Statement> statement = Statement::prepare(database, query);
    if (!statement) return std::move(statement).error();
    for (;;) {
        Result<bool> row = statement->step();
        if (!row) return std::move(row).error();
        if (!*row) return {};
        for (int column = 0; column < statement->columns(); ++column) addValue(*statement, column, digest);
    }
}

Result<std::int64_t> digestOf(Database& database, const Questions& questions) {
    Digest digest;
    for (const auto& [name, question] : questions) {
        digest.add(std::string_view(name));
        if (Result<void> added = addRows(database, question, digest); !added) return std::move(added).error();
    }
    return digest.value();
}

} // namespace burin
