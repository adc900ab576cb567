// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/clean_text.h"
#include "core/document/stores.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <utility>

namespace burin {

namespace {

/// A source has two columns, of which one holds the number of a row and the other is NULL.
const char* columnOf(PathSource source) noexcept {
    return source.isTake() ? "take" : "generated";
}

/// Whether the number can be that of a row: SQLite counts from 1.
bool namesARow(PathSource source) noexcept {
    return source.id != 0 && source.id != std::numeric_limits<std::int64_t>::min();
}

std::string kindOf(PathSource source) {
    return source.isTake() ? "take" : "generated moves";
}

Error unknownSource(PathSource source) {
    return {ErrorCode::nameUnknown, kindOf(source), std::to_string(source.id), {}};
}

/// Returns the setup that a source was made for.
Result<SetupId> setupOf(Database& database, PathSource source) {
    Result<Statement> row =
        Statement::prepare(database, std::string("SELECT setup FROM ") + columnOf(source) + " WHERE id = ?");
    if (!row) return std::move(row).error();
    if (Result<void> bound = row->bind(std::abs(source.id)); !bound) return std::move(bound).error();
    const Result<bool> found = row->step();
    if (!found) return found.error();
    if (!*found) return unknownSource(source);
    return SetupId{row->integer(0)};
}

/// Checks that a path's setup exists, and that its sources exist and belong to that setup.
Result<void> requireSources(Database& database, const StoredPath& path) {
    if (Result<void> known = requireSetup(database, path.setup); !known) return known;
    for (const PathSource source : path.sources) {
        if (!namesARow(source)) return unknownSource(source);
        const Result<SetupId> setup = setupOf(database, source);
        if (!setup) return setup.error();
        if (*setup != path.setup)
            return Error{ErrorCode::argumentInvalid, kindOf(source), std::to_string(source.id),
                         "sources of the path's own setup"};
    }
    return {};
}

Result<void> storeParts(Database& database, std::int64_t id, const StoredPath& path) {
    std::int64_t position = 0;
    for (const PathSource source : path.sources) {
        const std::string insert =
            std::string("INSERT INTO path_source(path, position, ") + columnOf(source) + ") VALUES(?, ?, ?)";
        if (Result<void> done = run(database, insert.c_str(), id, position++, std::abs(source.id)); !done) return done;
    }
    position = 0;
    for (const Edit& edit : path.edits)
        if (Result<void> done = run(database, "INSERT INTO path_edit VALUES(?, ?, ?)", id, position++, toJson(edit));
            !done)
            return done;
    return {};
}

Result<void> loadParts(Database& database, StoredPath& path) {
    Result<Statement> sources = Statement::prepare(
        database, "SELECT COALESCE(take, -generated) FROM path_source WHERE path = ? ORDER BY position");
    if (!sources) return std::move(sources).error();
    if (Result<void> bound = sources->bind(path.id); !bound) return bound;
    if (Result<void> read = forEachRow(*sources,
                                       [&]() -> Result<void> {
                                           path.sources.push_back({sources->integer(0)});
                                           if (namesARow(path.sources.back())) return {};
                                           return damaged(database, "path " + path.name + ", sources");
                                       });
        !read)
        return read;
    Result<Statement> edits =
        Statement::prepare(database, "SELECT json FROM path_edit WHERE path = ? ORDER BY position");
    if (!edits) return std::move(edits).error();
    if (Result<void> bound = edits->bind(path.id); !bound) return bound;
    return forEachRow(*edits, [&]() -> Result<void> {
        Result<Edit> edit = editFromJson(edits->text(0));
        if (!edit) return damaged(database, "path " + path.name + ", edit " + std::to_string(path.edits.size() + 1));
        path.edits.push_back(std::move(*edit));
        return {};
    });
}

Result<void> eraseParts(Database& database, std::int64_t id) {
    for (const char* erase : {"DELETE FROM path_source WHERE path = ?", "DELETE FROM path_edit WHERE path = ?"})
        if (Result<void> done = run(database, erase, id); !done) return done;
    return {};
}

/// Checks that the last statement changed a path; otherwise there is none of that id.
Result<void> requireChange(Database& database, std::int64_t id) {
    const Result<std::int64_t> found = database.integer("SELECT changes()");
    if (!found) return found.error();
    if (*found == 0) return Error{ErrorCode::nameUnknown, "path", std::to_string(id), {}};
    return {};
}

} // namespace

Result<void> requireUnused(Database& database, PathSource source) {
    const std::string select =
        std::string("SELECT name FROM path JOIN path_source ON path.id = path_source.path WHERE path_source.") +
        columnOf(source) + " = ?";
    Result<Statement> user = Statement::prepare(database, select);
    if (!user) return std::move(user).error();
    if (Result<void> bound = user->bind(std::abs(source.id)); !bound) return bound;
    const Result<bool> used = user->step();
    if (!used) return used.error();
    if (!*used) return {};
    return Error{ErrorCode::argumentInvalid, kindOf(source), std::to_string(source.id),
                 "a " + std::string(source.isTake() ? "take" : "source") +
                     " that no path uses (this one: " + std::string(user->text(0)) + ")"};
}

Result<std::int64_t> storePath(Database& database, const StoredPath& path) {
    if (Result<void> known = requireSources(database, path); !known) return std::move(known).error();
    if (Result<void> done =
            run(database, "INSERT INTO path(name, setup) VALUES(?, ?)", path.name, numberOf(path.setup));
        !done)
        return std::move(done).error();
    const Result<std::int64_t> id = database.integer("SELECT last_insert_rowid()");
    if (!id) return id;
    if (Result<void> done = storeParts(database, *id, path); !done) return std::move(done).error();
    return id;
}

Result<void> replacePath(Database& database, const StoredPath& path) {
    if (Result<void> known = requireSources(database, path); !known) return known;
    if (Result<void> done =
            run(database, "UPDATE path SET name = ?, setup = ? WHERE id = ?", path.name, numberOf(path.setup), path.id);
        !done)
        return done;
    if (Result<void> known = requireChange(database, path.id); !known) return known;
    if (Result<void> erased = eraseParts(database, path.id); !erased) return erased;
    return storeParts(database, path.id, path);
}

Result<void> erasePath(Database& database, std::int64_t id) {
    if (Result<void> erased = eraseParts(database, id); !erased) return erased;
    if (Result<void> erased = run(database, "DELETE FROM path WHERE id = ?", id); !erased) return erased;
    return requireChange(database, id);
}

Result<void> restorePath(Database& database, const StoredPath& path) {
    if (Result<void> known = requireSources(database, path); !known) return known;
    if (Result<void> done = run(database, "INSERT INTO path(id, name, setup) VALUES(?, ?, ?)", path.id, path.name,
                                numberOf(path.setup));
        !done)
        return done;
    return storeParts(database, path.id, path);
}

Result<std::vector<StoredPath>> loadPaths(Database& database) {
    Result<Statement> rows = Statement::prepare(database, "SELECT id, name, setup FROM path ORDER BY id");
    if (!rows) return std::move(rows).error();
    std::vector<StoredPath> paths;
    Result<void> read = forEachRow(*rows, [&]() -> Result<void> {
        StoredPath path;
        path.id = rows->integer(0);
        path.name = cleanLine(rows->text(1));
        path.setup = SetupId{rows->integer(2)};
        if (Result<void> parts = loadParts(database, path); !parts) return parts;
        paths.push_back(std::move(path));
        return {};
    });
    if (!read) return std::move(read).error();
    return paths;
}

Result<void> storeProgram(Database& database, const StoredProgram& program) {
    if (Result<void> known = requireSetup(database, program.setup); !known) return known;
    return run(
        database, "INSERT INTO program(name, dialect, machine, text, report_json, setup) VALUES(?, ?, ?, ?, ?, ?)",
        program.name, program.dialect, program.machine, program.text, program.reportJson, numberOf(program.setup));
}

Result<std::vector<StoredProgram>> loadPrograms(Database& database) {
    Result<Statement> rows = Statement::prepare(
        database, "SELECT name, dialect, machine, text, report_json, setup FROM program ORDER BY id");
    if (!rows) return std::move(rows).error();
    std::vector<StoredProgram> programs;
    Result<void> read = forEachRow(*rows, [&]() -> Result<void> {
        StoredProgram program;
        program.name = cleanLine(rows->text(0));
        program.dialect = cleanLine(rows->text(1));
        program.machine = cleanLine(rows->text(2));
        program.text = rows->text(3);
        program.reportJson = rows->text(4);
        program.setup = SetupId{rows->integer(5)};
        programs.push_back(std::move(program));
        return {};
    });
    if (!read) return std::move(read).error();
    return programs;
}

} // namespace burin
