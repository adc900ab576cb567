// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/working_copy.h"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <sqlite3.h>
#include <string>
#include <vector>

namespace burin::fixture {

namespace rows {

inline std::vector<std::string> asked(sqlite3* database, const std::string& sql) {
    std::vector<std::string> answer;
    sqlite3_stmt* statement = nullptr;
    if (sqlite3_prepare_v2(database, sql.c_str(), -1, &statement, nullptr) != SQLITE_OK) return {"?" + sql};
    while (sqlite3_step(statement) == SQLITE_ROW) {
        std::string row;
        for (int column = 0; column < sqlite3_column_count(statement); ++column) {
            const auto* bytes = static_cast<const char*>(sqlite3_column_blob(statement, column));
            const auto size = static_cast<std::size_t>(sqlite3_column_bytes(statement, column));
            const std::string value = bytes == nullptr ? std::string("-") : std::string(bytes, size);
            const bool isShort = sqlite3_column_type(statement, column) != SQLITE_BLOB && size < 2000;
            row += " | " + (isShort ? value : std::to_string(std::hash<std::string>()(value)));
        }
        answer.push_back(row);
    }
    sqlite3_finalize(statement);
    return answer;
}

} // namespace rows

/// Every row of the working copy of a project, as text with the name of its table, sorted. Left out are what identifies
/// the file, the position in the work and kept workpieces, which are derived; and takes that were removed.
inline std::vector<std::string> rowsOf(const std::filesystem::path& file) {
    sqlite3* database = nullptr;
    sqlite3_open_v2(WorkingCopy::pathBeside(file).c_str(), &database, SQLITE_OPEN_READWRITE, nullptr);
    std::vector<std::string> all;
    for (const std::string& name : rows::asked(database, "SELECT name FROM sqlite_schema WHERE type = 'table' AND name "
                                                         "NOT IN ('document', 'kept_workpiece', 'sqlite_sequence')")) {
        const std::string table = name.substr(3);
        std::string which;
        if (table == "take") which = " WHERE removed = 0";
        for (const char* ofTake : {"sample_chunk", "take_material", "undone_stretch", "switched_off_stretch"})
            if (table == ofTake) which = " WHERE take IN (SELECT id FROM take WHERE removed = 0)";
        if (table == "milling_setting") which = " WHERE name <> 'left_at'";
        for (const std::string& row : rows::asked(database, "SELECT * FROM " + table + which))
            all.push_back(table + row);
    }
    sqlite3_close(database);
    std::ranges::sort(all);
    return all;
}

/// What only one of two states holds, for the message of a test; empty if they are equal.
inline std::string difference(const std::vector<std::string>& one, const std::vector<std::string>& other) {
    std::string text;
    for (const std::string& row : one)
        if (std::ranges::count(one, row) != std::ranges::count(other, row)) text += "\n- " + row.substr(0, 400);
    for (const std::string& row : other)
        if (std::ranges::count(one, row) != std::ranges::count(other, row)) text += "\n+ " + row.substr(0, 400);
    return text;
}

} // namespace burin::fixture
