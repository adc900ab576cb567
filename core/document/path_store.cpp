// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/clean_text.h"
#include "core/document/stores.h"

#include <algorithm>
#include <utility>

namespace burin {

namespace {

/// That a path's setup is there, and its takes, which are of that setup.
Result<void> requireSources(Database& database, const StoredPath& path) {
    if (Result<void> known = requireSetup(database, path.setup); !known) return known;
    const Result<std::vector<TakeInfo>> takes = loadTakes(database);
    if (!takes) return takes.error();
    for (const std::int64_t id : path.takes) {
        const auto take = std::ranges::find(*takes, id, &TakeInfo::id);
        if (take == takes->end()) return Error{ErrorCode::nameUnknown, "take", std::to_string(id), {}};
        if (take->setup != path.setup)
            return Error{ErrorCode::argumentInvalid, "take", std::to_string(id), "takes of the path's own setup"};
    }
    return {};
}

Result<void> storeParts(Database& database, std::int64_t id, const StoredPath& path) {
    std::int64_t position = 0;
    for (const std::int64_t take : path.takes)
        if (Result<void> done = run(database, "INSERT INTO path_take VALUES(?, ?, ?)", id, position++, take); !done)
            return done;
    position = 0;
    for (const Edit& edit : path.edits)
        if (Result<void> done = run(database, "INSERT INTO path_edit VALUES(?, ?, ?)", id, position++, toJson(edit));
            !done)
            return done;
    return {};
}

Result<void> loadParts(Database& database, StoredPath& path) {
    Result<Statement> takes =
        Statement::prepare(database, "SELECT take FROM path_take WHERE path = ? ORDER BY position");
    if (!takes) return std::move(takes).error();
    if (Result<void> bound = takes->bind(path.id); !bound) return bound;
    if (Result<void> read = forEachRow(*takes,
                                       [&]() -> Result<void> {
                                           path.takes.push_back(takes->integer(0));
                                           return {};
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
    for (const char* erase : {"DELETE FROM path_take WHERE path = ?", "DELETE FROM path_edit WHERE path = ?"})
        if (Result<void> done = run(database, erase, id); !done) return done;
    return {};
}

/// What was just changed was no path: there is none of that id.
Result<void> requireChange(Database& database, std::int64_t id) {
    const Result<std::int64_t> found = database.integer("SELECT changes()");
    if (!found) return found.error();
    if (*found == 0) return Error{ErrorCode::nameUnknown, "path", std::to_string(id), {}};
    return {};
}

} // namespace

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
