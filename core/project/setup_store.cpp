// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/project/setup_record.h"
#include "core/project/stores.h"

#include <utility>

namespace burin {

namespace {

Error noSetup(const Database& database) {
    return {ErrorCode::projectIncomplete, "embedded stock", "burin embed", database.subject()};
}

} // namespace

Result<void> storeSetup(Database& database, const Setup& setup) {
    const Result<std::string> text = toJson(setup);
    if (!text) return text.error();
    return run(database, "INSERT INTO setup VALUES(1, ?) ON CONFLICT(id) DO UPDATE SET json = excluded.json", *text);
}

Result<Setup> loadSetup(Database& database) {
    Result<Statement> row = Statement::prepare(database, "SELECT json FROM setup");
    if (!row) return std::move(row).error();
    const Result<bool> found = row->step();
    if (!found) return found.error();
    if (!*found) return noSetup(database);
    std::optional<Setup> setup = setupFromJson(row->text(0));
    if (!setup) return damaged(database, "setup");
    return std::move(*setup);
}

Result<void> storeMaterials(Database& database, const std::vector<Property>& materials) {
    if (Result<void> done = database.execute("DELETE FROM material"); !done) return done;
    std::int64_t position = 0;
    for (const Property& material : materials)
        if (Result<void> done =
                run(database, "INSERT INTO material VALUES(?, ?, ?)", position++, material.id, toJson(material));
            !done)
            return done;
    return {};
}

Result<std::vector<Property>> loadMaterials(Database& database) {
    Result<Statement> rows = Statement::prepare(database, "SELECT json FROM material ORDER BY position");
    if (!rows) return std::move(rows).error();
    std::vector<Property> materials;
    Result<void> read = forEachRow(*rows, [&]() -> Result<void> {
        Result<Property> material = propertyFromJson(rows->text(0), database.subject());
        if (!material) return damaged(database, "material " + std::to_string(materials.size() + 1));
        materials.push_back(std::move(*material));
        return {};
    });
    if (!read) return std::move(read).error();
    if (materials.empty()) return noSetup(database);
    return materials;
}

Result<void> storeTool(Database& database, const Tool& tool) {
    return run(database, "INSERT INTO tool(id, json) VALUES(?, ?) ON CONFLICT(id) DO UPDATE SET json = excluded.json",
               tool.id, toJson(tool));
}

Result<std::vector<Tool>> loadTools(Database& database) {
    Result<Statement> rows = Statement::prepare(database, "SELECT json FROM tool ORDER BY position");
    if (!rows) return std::move(rows).error();
    std::vector<Tool> tools;
    Result<void> read = forEachRow(*rows, [&]() -> Result<void> {
        Result<Tool> tool = toolFromJson(rows->text(0), database.subject());
        if (!tool) return damaged(database, "tool " + std::to_string(tools.size() + 1));
        tools.push_back(std::move(*tool));
        return {};
    });
    if (!read) return std::move(read).error();
    return tools;
}

} // namespace burin
