// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/document/schema.h"

#include <map>
#include <string>
#include <string_view>

namespace burin {

namespace {

// README.md describes the columns.
constexpr const char* tables = R"sql(
CREATE TABLE document(
    id INTEGER PRIMARY KEY CHECK(id = 1),
    save_id BLOB NOT NULL,
    next_save_id BLOB NOT NULL,
    revision INTEGER NOT NULL,
    changes INTEGER NOT NULL,
    saved_changes INTEGER NOT NULL,
    digest INTEGER);
INSERT INTO document VALUES(1, x'', x'', 0, 0, 0, NULL);
CREATE TABLE model(
    id INTEGER PRIMARY KEY CHECK(id = 1),
    source_file TEXT NOT NULL,
    format TEXT NOT NULL,
    length_unit TEXT NOT NULL,
    unit_scale REAL,
    mesh_chord REAL,
    brep BLOB NOT NULL);
CREATE TABLE body(
    position INTEGER PRIMARY KEY,
    name TEXT NOT NULL,
    colour INTEGER,
    volume REAL,
    area REAL,
    box BLOB NOT NULL,
    mesh BLOB NOT NULL,
    open_edges INTEGER NOT NULL,
    face_count INTEGER NOT NULL);
CREATE TABLE import_note(
    position INTEGER PRIMARY KEY,
    kind TEXT NOT NULL,
    text TEXT NOT NULL);
CREATE TABLE setup(
    id INTEGER PRIMARY KEY CHECK(id = 1),
    json TEXT NOT NULL);
CREATE TABLE material(
    position INTEGER PRIMARY KEY,
    id TEXT NOT NULL,
    json TEXT NOT NULL);
CREATE TABLE tool(
    position INTEGER PRIMARY KEY,
    id TEXT NOT NULL UNIQUE,
    json TEXT NOT NULL);
CREATE TABLE take(
    id INTEGER PRIMARY KEY AUTOINCREMENT,
    name TEXT NOT NULL,
    tool_id TEXT NOT NULL,
    allowance REAL,
    tick_period REAL,
    started_unix_time REAL,
    stylus TEXT NOT NULL,
    complete INTEGER NOT NULL);
CREATE TABLE sample_chunk(
    id INTEGER PRIMARY KEY,
    take INTEGER NOT NULL REFERENCES take(id),
    first INTEGER NOT NULL,
    count INTEGER NOT NULL,
    samples BLOB NOT NULL,
    UNIQUE(take, first));
CREATE TABLE path(
    id INTEGER PRIMARY KEY AUTOINCREMENT,
    name TEXT NOT NULL);
CREATE TABLE path_take(
    path INTEGER NOT NULL REFERENCES path(id),
    position INTEGER NOT NULL,
    take INTEGER NOT NULL REFERENCES take(id),
    PRIMARY KEY(path, position));
CREATE TABLE path_edit(
    path INTEGER NOT NULL REFERENCES path(id),
    position INTEGER NOT NULL,
    json TEXT NOT NULL,
    PRIMARY KEY(path, position));
CREATE TABLE program(
    id INTEGER PRIMARY KEY AUTOINCREMENT,
    name TEXT NOT NULL,
    dialect TEXT NOT NULL,
    machine TEXT NOT NULL,
    text TEXT NOT NULL,
    report_json TEXT NOT NULL);
)sql";

constexpr const char* undoneInterval = R"sql(
CREATE TABLE undone_stretch(
    id INTEGER PRIMARY KEY,
    take INTEGER NOT NULL REFERENCES take(id),
    first INTEGER NOT NULL,
    count INTEGER NOT NULL,
    UNIQUE(take, first));
)sql";

constexpr const char* surroundings = R"sql(
CREATE TABLE obstacle(
    position INTEGER PRIMARY KEY,
    json TEXT NOT NULL,
    mesh BLOB);
CREATE TABLE guide(
    position INTEGER PRIMARY KEY,
    json TEXT NOT NULL,
    curve BLOB);
CREATE TABLE milling_setting(
    name TEXT PRIMARY KEY,
    json TEXT NOT NULL);
)sql";

// The tables of version 4, in the form that new and migrated projects share: take, path and program got a column, which
// SQLite stores in the statement as it was added.
constexpr const char* setups = R"sql(
CREATE TABLE setup(
    id INTEGER PRIMARY KEY AUTOINCREMENT,
    name TEXT NOT NULL,
    json TEXT);
CREATE TABLE obstacle(
    setup INTEGER NOT NULL REFERENCES setup(id),
    position INTEGER NOT NULL,
    json TEXT NOT NULL,
    mesh BLOB,
    PRIMARY KEY(setup, position));
CREATE TABLE guide(
    setup INTEGER NOT NULL REFERENCES setup(id),
    position INTEGER NOT NULL,
    json TEXT NOT NULL,
    curve BLOB,
    PRIMARY KEY(setup, position));
CREATE TABLE setup_setting(
    setup INTEGER NOT NULL REFERENCES setup(id),
    name TEXT NOT NULL,
    json TEXT NOT NULL,
    PRIMARY KEY(setup, name));
)sql";
constexpr const char* sources = R"sql(
CREATE TABLE take_material(
    take INTEGER NOT NULL REFERENCES take(id),
    property INTEGER NOT NULL,
    material TEXT NOT NULL,
    PRIMARY KEY(take, property));
CREATE TABLE generated(
    id INTEGER PRIMARY KEY AUTOINCREMENT,
    setup INTEGER NOT NULL REFERENCES setup(id),
    name TEXT NOT NULL,
    tool_id TEXT NOT NULL,
    allowance REAL);
CREATE TABLE generated_chunk(
    generated INTEGER NOT NULL REFERENCES generated(id),
    stroke INTEGER NOT NULL,
    first INTEGER NOT NULL,
    count INTEGER NOT NULL,
    points BLOB NOT NULL,
    PRIMARY KEY(generated, stroke, first));
CREATE TABLE path_source(
    path INTEGER NOT NULL REFERENCES path(id),
    position INTEGER NOT NULL,
    take INTEGER REFERENCES take(id),
    generated INTEGER REFERENCES generated(id),
    PRIMARY KEY(path, position),
    CHECK((take IS NULL) != (generated IS NULL)));
)sql";
constexpr const char* intoSources = R"sql(
INSERT INTO path_source SELECT path, position, take, NULL FROM path_take;
DROP TABLE path_take;
)sql";
constexpr const char* beforeSetups = R"sql(
ALTER TABLE setup RENAME TO one_setup;
ALTER TABLE obstacle RENAME TO one_obstacle;
ALTER TABLE guide RENAME TO one_guide;
)sql";
constexpr const char* intoSetups = R"sql(
INSERT INTO setup(id, name, json) VALUES(1, '', (SELECT json FROM one_setup));
INSERT INTO obstacle SELECT 1, position, json, mesh FROM one_obstacle;
INSERT INTO guide SELECT 1, position, json, curve FROM one_guide;
INSERT INTO setup_setting SELECT 1, name, json FROM milling_setting WHERE name IN ('axis_mode', 'travel', 'target');
DELETE FROM milling_setting WHERE name IN ('axis_mode', 'travel', 'target');
DROP TABLE one_setup;
DROP TABLE one_obstacle;
DROP TABLE one_guide;
ALTER TABLE take ADD COLUMN setup INTEGER NOT NULL DEFAULT 1;
ALTER TABLE path ADD COLUMN setup INTEGER NOT NULL DEFAULT 1;
ALTER TABLE program ADD COLUMN setup INTEGER NOT NULL DEFAULT 1;
)sql";
constexpr std::string_view setupColumn = ",setupINTEGERNOTNULLDEFAULT1)";

constexpr const char* stockVolumes = R"sql(
CREATE TABLE stock_volume(
    setup INTEGER PRIMARY KEY REFERENCES setup(id),
    name TEXT NOT NULL,
    volume BLOB NOT NULL);
)sql";

/// A mirrored part differs from the part in its B-rep's file; and the job's program becomes that of its only setup.
constexpr const char* placements = R"sql(
ALTER TABLE model ADD COLUMN brep_placement TEXT NOT NULL DEFAULT '';
INSERT INTO setup_setting SELECT 1, name, json FROM milling_setting WHERE name IN ('program_draft', 'kept_program');
DELETE FROM milling_setting WHERE name IN ('program_draft', 'kept_program');
)sql";
constexpr std::string_view brepPlacementColumn = ",brep_placementTEXTNOTNULLDEFAULT'')";
constexpr std::string_view takeRemoved = ",removedINTEGERNOTNULLDEFAULT0)";
constexpr std::string_view requestColumn = ",requestTEXTNOTNULLDEFAULT'')";

constexpr const char* timeTables = R"sql(
CREATE TABLE kept_workpiece(
    setup INTEGER NOT NULL REFERENCES setup(id),
    take INTEGER NOT NULL,
    samples INTEGER NOT NULL,
    made_of INTEGER NOT NULL,
    strokes TEXT NOT NULL,
    volume BLOB NOT NULL,
    PRIMARY KEY(setup, take, samples));
CREATE TABLE marker(
    setup INTEGER NOT NULL REFERENCES setup(id),
    take INTEGER NOT NULL,
    samples INTEGER NOT NULL,
    name TEXT NOT NULL,
    PRIMARY KEY(setup, take, samples));
CREATE TABLE switched_off_stretch(
    take INTEGER NOT NULL REFERENCES take(id),
    first INTEGER NOT NULL,
    count INTEGER NOT NULL,
    PRIMARY KEY(take, first));
)sql";

std::string withoutSpaces(std::string_view sql) {
    std::string text;
    for (const char character : sql)
        if (character != ' ' && character != '\n' && character != '\t' && character != '\r') text += character;
    return text;
}

/// Returns the tables that `sql` creates, by name, with their statements as stored by the database, without spaces.
std::map<std::string, std::string> statementsOf(std::string_view sql) {
    constexpr std::string_view make = "CREATE TABLE ";
    std::map<std::string, std::string> statements;
    for (std::size_t at = sql.find(make); at != std::string_view::npos; at = sql.find(make, at + 1)) {
        const std::string_view statement = sql.substr(at, sql.find(';', at) - at);
        const std::string_view name = statement.substr(make.size(), statement.find('(') - make.size());
        statements[std::string(name)] = withoutSpaces(statement);
    }
    return statements;
}

/// Appends a column to a statement as SQLite does: it stores the column as it was written.
void addColumn(std::string& statement, std::string_view column) {
    statement.replace(statement.size() - 1, 1, column);
}

void addSetupsTo(std::map<std::string, std::string>& expected) {
    for (const char* made : {setups, sources})
        for (const auto& [name, statement] : statementsOf(made)) expected[name] = statement;
    expected.erase("path_take");
    for (const char* name : {"take", "path", "program"}) addColumn(expected[name], setupColumn);
}

Result<void> setVersion(Database& file, int version) {
    return file.execute(("PRAGMA user_version = " + std::to_string(version)).c_str());
}

} // namespace

Result<void> createSchema(Database& file) {
    Result<Transaction> whole = Transaction::begin(file, Transaction::Kind::write);
    if (!whole) return std::move(whole).error();
    const std::string identity = "PRAGMA application_id = " + std::to_string(projectApplicationId);
    if (Result<void> done = file.execute(identity.c_str()); !done) return done;
    if (Result<void> done = setVersion(file, projectVersion); !done) return done;
    if (Result<void> done = file.execute(tables); !done) return done;
    for (const Migration& step : projectMigrations) // the same form, however a project came to it
        if (Result<void> done = step.apply(file); !done) return done;
    return whole->commit();
}

Result<void> addUndoneIntervals(Database& file) {
    return file.execute(undoneInterval);
}

Result<void> addSurroundings(Database& file) {
    return file.execute(surroundings);
}

Result<void> addSetups(Database& file) {
    for (const char* part : {beforeSetups, setups, intoSetups, sources, intoSources})
        if (Result<void> done = file.execute(part); !done) return done;
    return {};
}

/// The tables stay the same; the setup's JSON was extended, and an older Burin would mill an insert as a part.
Result<void> addRoles(Database&) {
    return {};
}

Result<void> addStockVolumes(Database& file) {
    return file.execute(stockVolumes);
}

Result<void> addPlacements(Database& file) {
    return file.execute(placements);
}

/// The tables stay the same; an older Burin would always post for the work offset G54, regardless of the setup's JSON.
Result<void> addProgramZero(Database&) {
    return {};
}

Result<void> addPassRequests(Database& file) {
    return file.execute("ALTER TABLE generated ADD COLUMN request TEXT NOT NULL DEFAULT ''");
}

Result<void> addTime(Database& file) {
    if (Result<void> done = file.execute(timeTables); !done) return done;
    return file.execute("ALTER TABLE take ADD COLUMN removed INTEGER NOT NULL DEFAULT 0");
}

/// Chunks of generated moves may have a further form, which is written only from this version on.
Result<void> addStatedFeeds(Database&) {
    return {};
}

/// Chunks of samples may have a further form, which is written only from this version on.
Result<void> addTorque(Database&) {
    return {};
}
Result<void> addStatedCoolant(Database&) {
    return {};
}

Result<void> checkIdentity(Database& file, int newest) {
    const Result<std::int64_t> application = file.integer("PRAGMA application_id");
    if (!application) return application.error();
    if (*application != projectApplicationId)
        return Error{ErrorCode::projectNotBurin, file.subject(), {}, "application id " + std::to_string(*application)};
    const Result<std::int64_t> version = file.integer("PRAGMA user_version");
    if (!version) return version.error();
    if (*version > newest) return Error{ErrorCode::fileFromNewerBurin, file.subject(), {}, std::to_string(*version)};
    if (*version < 1) return Error{ErrorCode::fileDamaged, file.subject(), {}, "version " + std::to_string(*version)};
    return {};
}

Result<void> checkSchema(Database& file) {
    const Result<std::int64_t> version = file.integer("PRAGMA user_version");
    if (!version) return version.error();
    std::map<std::string, std::string> expected = statementsOf(tables);
    if (*version >= 2) expected.merge(statementsOf(undoneInterval));
    if (*version >= 3) expected.merge(statementsOf(surroundings));
    if (*version >= 4) addSetupsTo(expected);
    if (*version >= 6) expected.merge(statementsOf(stockVolumes));
    if (*version >= 7) addColumn(expected["model"], brepPlacementColumn);
    if (*version >= 9) addColumn(expected["generated"], requestColumn);
    if (*version >= 10) {
        expected.merge(statementsOf(timeTables));
        addColumn(expected["take"], takeRemoved);
    }
    Result<Statement> rows =
        Statement::prepare(file, "SELECT name, sql FROM sqlite_schema WHERE type IN ('table', 'index')");
    if (!rows) return std::move(rows).error();
    for (;;) {
        const Result<bool> row = rows->step();
        if (!row) return row.error();
        if (!*row) break;
        const std::string name(rows->text(0));
        const auto known = expected.find(name);
        const bool own = name.starts_with("sqlite_"); // SQLite's own tables, whose names can't be used by others
        if (!own && (known == expected.end() || known->second != withoutSpaces(rows->text(1))))
            return Error{ErrorCode::fileDamaged, file.subject(), name, "not in the schema"};
        if (known != expected.end()) expected.erase(known);
    }
    if (expected.empty()) return {};
    return Error{ErrorCode::fileDamaged, file.subject(), expected.begin()->first, "is missing"};
}

Result<void> upgrade(Database& file, std::span<const Migration> migrations) {
    const int newest = static_cast<int>(migrations.size()) + 1;
    if (Result<void> ours = checkIdentity(file, newest); !ours) return ours;
    const Result<std::int64_t> found = file.integer("PRAGMA user_version");
    if (!found) return found.error();
    if (*found == newest) return {};
    Result<Transaction> whole = Transaction::begin(file, Transaction::Kind::write);
    if (!whole) return std::move(whole).error();
    for (const Migration& step : migrations.subspan(static_cast<std::size_t>(*found) - 1))
        if (Result<void> done = step.apply(file); !done) return done;
    if (Result<void> done = setVersion(file, newest); !done) return done;
    return whole->commit();
}

} // namespace burin
