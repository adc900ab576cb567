// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/document/document_state.h"

#include "core/document/digest.h"

#include <random>
#include <string_view>
#include <utility>
#include <vector>

namespace burin {

namespace {

Result<std::vector<std::string>> tableNames(Database& database) {
    Result<Statement> statement = Statement::prepare(
        database, "SELECT name FROM sqlite_schema WHERE type = 'table' AND name <> 'document' ORDER BY name");
    if (!statement) return std::move(statement).error();
    std::vector<std::string> names;
    for (;;) {
        Result<bool> row = statement->step();
        if (!row) return std::move(row).error();
        if (!*row) return names;
        names.emplace_back(statement->text(0));
    }
}

std::string identifier(std::string_view name) {
    std::string result = "\"";
    for (const char character : name) result.append(character == '"' ? 2 : 1, character);
    return result + "\"";
}

Result<void> addTable(Database& database, const std::string& name, Digest& digest) {
    digest.add(name);
    return addRows(database, "SELECT * FROM " + identifier(name) + " ORDER BY rowid", digest);
}

} // namespace

Result<DocumentState> documentState(Database& database) {
    Result<Statement> statement = Statement::prepare(
        database, "SELECT save_id, next_save_id, revision, changes, saved_changes, digest FROM document");
    if (!statement) return std::move(statement).error();
    Result<bool> row = statement->step();
    if (!row) return std::move(row).error();
    if (!*row) return Error{ErrorCode::fileDamaged, database.subject(), {}, "table document is empty"};
    DocumentState state;
    state.saveId = statement->blob(0);
    state.nextSaveId = statement->blob(1);
    state.revision = statement->integer(2);
    state.changes = statement->integer(3);
    state.savedChanges = statement->integer(4);
    if (!statement->isNull(5)) state.digest = statement->integer(5);
    return state;
}

Result<void> setDocumentState(Database& database, const DocumentState& state) {
    return run(database,
               "UPDATE document SET save_id = ?, next_save_id = ?, revision = ?, changes = ?, saved_changes = ?, "
               "digest = ?",
               BlobView{state.saveId}, BlobView{state.nextSaveId}, state.revision, state.changes, state.savedChanges,
               state.digest);
}

Result<void> countChange(Database& database) {
    return database.execute("UPDATE document SET changes = changes + 1");
}

std::string newSaveId() {
    std::random_device source;
    std::string id;
    for (int word = 0; word < 4; ++word) {
        const unsigned bits = source();
        for (unsigned byte = 0; byte < 4; ++byte) id.push_back(static_cast<char>((bits >> (8 * byte)) & 0xff));
    }
    return id;
}

Result<std::int64_t> contentDigest(Database& database) {
    const Result<std::vector<std::string>> names = tableNames(database);
    if (!names) return names.error();
    Digest digest;
    for (const std::string& name : *names)
        if (Result<void> added = addTable(database, name, digest); !added) return std::move(added).error();
    return digest.value();
}

Result<std::int64_t> jobDigest(Database& database, SetupId setup) {
    const std::string id = std::to_string(numberOf(setup));
    const std::string takes = "(SELECT id FROM take WHERE removed = 0 AND setup = " + id + ")";
    const std::string paths = "(SELECT id FROM path WHERE setup = " + id + ")";
    const std::string generated = "(SELECT id FROM generated WHERE setup = " + id + ")";
    // Recordings only grow and generated moves are never changed, so their length identifies their content.
    const Questions questions{
        std::pair{"model", std::string("SELECT * FROM model")},
        std::pair{"body", std::string("SELECT * FROM body ORDER BY rowid")},
        std::pair{"setup", "SELECT id, json FROM setup WHERE id = " + id},
        std::pair{"material", std::string("SELECT * FROM material ORDER BY rowid")},
        std::pair{"obstacle", "SELECT * FROM obstacle WHERE setup = " + id + " ORDER BY position"},
        // If nothing is switched off, the result is the same as that of versions without switching off.
        std::pair{"undone_stretch", "SELECT * FROM (SELECT * FROM undone_stretch WHERE take IN " + takes +
                                        " ORDER BY rowid) UNION ALL SELECT * FROM (SELECT 0, take, first, count FROM "
                                        "switched_off_stretch WHERE take IN " +
                                        takes + " ORDER BY take, first)"},
        std::pair{"path", "SELECT * FROM path WHERE setup = " + id + " ORDER BY rowid"},
        std::pair{"path_source", "SELECT * FROM path_source WHERE path IN " + paths + " ORDER BY path, position"},
        std::pair{"path_edit", "SELECT * FROM path_edit WHERE path IN " + paths + " ORDER BY path, position"},
        std::pair{"take", "SELECT id, tool_id, allowance, tick_period FROM take WHERE id IN " + takes + " ORDER BY id"},
        std::pair{"samples", "SELECT take, first, count FROM sample_chunk WHERE take IN " + takes + " ORDER BY 1, 2"},
        std::pair{"generated", "SELECT id, tool_id, allowance FROM generated WHERE setup = " + id + " ORDER BY id"},
        std::pair{"moves", "SELECT generated, stroke, first, count FROM generated_chunk WHERE generated IN " +
                               generated + " ORDER BY 1, 2, 3"},
        std::pair{"travel", "SELECT setup, json FROM setup_setting WHERE name = 'travel' AND setup = " + id}};
    return digestOf(database, questions);
}

} // namespace burin
