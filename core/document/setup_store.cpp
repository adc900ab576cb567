// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/clean_text.h"
#include "core/document/project_step.h"
#include "core/document/setup_record.h"
#include "core/document/stores.h"

#include <algorithm>
#include <utility>

namespace burin {

namespace {

Error noSetup(const Database& database) {
    return {ErrorCode::projectIncomplete, "embedded stock", "burin embed", database.subject()};
}

/// The volume may be large, so one that is already stored is not written again.
Result<void> storeStockVolume(Database& database, SetupId id, const Setup& setup) {
    if (!setup.volume) return run(database, "DELETE FROM stock_volume WHERE setup = ?", numberOf(id));
    Result<Statement> row = Statement::prepare(database, "SELECT json FROM setup WHERE id = ?");
    if (!row) return std::move(row).error();
    if (Result<void> bound = row->bind(numberOf(id)); !bound) return bound;
    const Result<bool> found = row->step();
    if (!found) return found.error();
    if (*found && !row->isNull(0) && stockChecksumOf(row->text(0)) == setup.volume->checksum()) return {};
    return run(database, "INSERT OR REPLACE INTO stock_volume(setup, name, volume) VALUES(?, ?, ?)", numberOf(id),
               setup.volume->name(), BlobView{setup.volume->content()});
}

Result<StockVolume::Shared> loadStockVolume(Database& database, SetupId id) {
    Result<Statement> row = Statement::prepare(database, "SELECT name, volume FROM stock_volume WHERE setup = ?");
    if (!row) return std::move(row).error();
    if (Result<void> bound = row->bind(numberOf(id)); !bound) return std::move(bound).error();
    const Result<bool> found = row->step();
    if (!found) return found.error();
    if (!*found) return damaged(database, "stock_volume");
    Progress whole;
    Result<StockVolume::Shared> volume = StockVolume::read(std::string(row->blob(1)), cleanLine(row->text(0)), whole);
    if (!volume && volume.error().code != ErrorCode::outOfMemory && volume.error().code != ErrorCode::volumeOutOfMemory)
        return damaged(database, "stock_volume");
    return volume;
}

/// Returns its JSON; empty if nothing is embedded yet.
Result<std::optional<std::string>> recordOf(Database& database, SetupId id) {
    if (Result<void> known = requireSetup(database, id); !known) return std::move(known).error();
    Result<Statement> row = Statement::prepare(database, "SELECT json FROM setup WHERE id = ?");
    if (!row) return std::move(row).error();
    if (Result<void> bound = row->bind(numberOf(id)); !bound) return std::move(bound).error();
    const Result<bool> found = row->step();
    if (!found) return found.error();
    if (!*found || row->isNull(0)) return std::optional<std::string>();
    return std::optional(std::string(row->text(0)));
}

/// Returns the stored setups other than `id`, without the volumes of their stocks.
Result<std::vector<Setup>> otherSetups(Database& database, SetupId id) {
    const Result<std::vector<SetupName>> setups = loadSetups(database);
    if (!setups) return setups.error();
    std::vector<Setup> others;
    for (const SetupName& name : *setups) {
        if (name.id == id) continue;
        const Result<std::optional<std::string>> record = recordOf(database, name.id);
        if (!record) return record.error();
        if (!*record) continue;
        std::optional<Setup> setup = setupFromJson(**record);
        if (!setup) return damaged(database, "setup");
        others.push_back(std::move(*setup));
    }
    return others;
}

/// Returns the stored materials that other setups use, and that are not among `materials`.
Result<std::vector<Property>> namedByOthers(Database& database, SetupId id, const std::vector<Property>& materials) {
    const Result<std::vector<Setup>> others = otherSetups(database, id);
    if (!others) return others.error();
    if (others->empty()) return std::vector<Property>{};
    Result<std::vector<Property>> stored = loadMaterials(database);
    if (!stored && stored.error().code == ErrorCode::projectIncomplete) return std::vector<Property>{};
    if (!stored) return stored;
    std::erase_if(*stored, [&](const Property& material) {
        const bool named = std::ranges::any_of(*others, [&](const Setup& setup) {
            const std::vector<std::string> used = materialsUsed(setup);
            return std::ranges::find(used, material.id) != used.end();
        });
        return !named || std::ranges::find(materials, material.id, &Property::id) != materials.end();
    });
    return stored;
}

/// Checks that removing it would delete nothing that a user made.
Result<void> requireEmpty(Database& database, SetupId id) {
    const std::string number = std::to_string(numberOf(id));
    // Deleted takes are removed with their setup.
    for (const char* table : {"take WHERE removed = 0 AND", "generated WHERE", "path WHERE", "program WHERE"}) {
        const Result<std::int64_t> count =
            database.integer(("SELECT COUNT(*) FROM " + std::string(table) + " setup = " + number).c_str());
        if (!count) return count.error();
        if (*count > 0)
            return Error{ErrorCode::argumentInvalid, "setup", number, "a setup without recordings, paths and programs"};
    }
    const Result<std::vector<Setup>> others = otherSetups(database, id);
    if (!others) return others.error();
    const auto isFromIt = [id](const Setup& setup) { return setup.leftBy && setup.leftBy->setup == id; };
    if (std::ranges::any_of(*others, isFromIt))
        return Error{ErrorCode::argumentInvalid, "setup", number, "a setup whose workpiece no other one's stock is"};
    return {};
}

} // namespace

Result<SetupId> storeNewSetup(Database& database, const std::string& name) {
    if (Result<void> done = run(database, "INSERT INTO setup(name) VALUES(?)", name); !done)
        return std::move(done).error();
    const Result<std::int64_t> id = database.integer("SELECT last_insert_rowid()");
    if (!id) return id.error();
    return SetupId{*id};
}

Result<std::vector<SetupName>> loadSetups(Database& database) {
    Result<Statement> rows = Statement::prepare(database, "SELECT id, name FROM setup ORDER BY id");
    if (!rows) return std::move(rows).error();
    std::vector<SetupName> setups;
    Result<void> read = forEachRow(*rows, [&]() -> Result<void> {
        setups.push_back({SetupId{rows->integer(0)}, cleanLine(rows->text(1))});
        return {};
    });
    if (!read) return std::move(read).error();
    if (setups.empty()) return damaged(database, "setup");
    return setups;
}

Result<void> requireSetup(Database& database, SetupId id) {
    const Result<std::vector<SetupName>> setups = loadSetups(database);
    if (!setups) return setups.error();
    if (std::ranges::find(*setups, id, &SetupName::id) != setups->end()) return {};
    return Error{ErrorCode::nameUnknown, "setup", std::to_string(numberOf(id)), {}};
}

Result<void> storeSetup(Database& database, SetupId id, const Setup& setup) {
    if (Result<void> known = requireSetup(database, id); !known) return known;
    const Result<std::string> text = toJson(setup);
    if (!text) return text.error();
    if (Result<void> stored = storeStockVolume(database, id, setup); !stored) return stored;
    return run(database, "UPDATE setup SET json = ? WHERE id = ?", *text, numberOf(id));
}

Result<Setup> loadSetup(Database& database, SetupId id) {
    const Result<std::optional<std::string>> record = recordOf(database, id);
    if (!record) return record.error();
    if (!*record) return noSetup(database);
    std::optional<Setup> setup = setupFromJson(**record);
    if (!setup) return damaged(database, "setup");
    if (const std::optional<std::uint64_t> checksum = stockChecksumOf(**record)) {
        Result<StockVolume::Shared> volume = loadStockVolume(database, id);
        if (!volume) return std::move(volume).error();
        if ((*volume)->checksum() != *checksum) return damaged(database, "stock_volume");
        setup->volume = std::move(*volume);
    }
    return std::move(*setup);
}

Result<Placement> loadPlacement(Database& database, SetupId id) {
    const Result<std::optional<std::string>> record = recordOf(database, id);
    if (!record) return record.error();
    if (!*record) return Placement{};
    const std::optional<Setup> setup = setupFromJson(**record);
    if (!setup) return damaged(database, "setup");
    return setup->placement;
}

Result<void> renameSetup(Database& database, SetupId id, const std::string& name) {
    if (Result<void> known = requireSetup(database, id); !known) return known;
    return run(database, "UPDATE setup SET name = ? WHERE id = ?", name, numberOf(id));
}

Result<void> eraseSetup(Database& database, SetupId id) {
    if (Result<void> known = requireSetup(database, id); !known) return known;
    if (Result<void> unused = requireEmpty(database, id); !unused) return unused;
    if (Result<void> erased = eraseHiddenTakes(database, id); !erased) return erased;
    // Until the transaction ends, rows may belong to a setup that is gone.
    if (Result<void> deferred = database.execute("PRAGMA defer_foreign_keys = ON"); !deferred) return deferred;
    if (Result<void> done = run(database, "DELETE FROM setup WHERE id = ?", numberOf(id)); !done) return done;
    return removeOrphans(database);
}

Result<void> storeMaterials(Database& database, SetupId id, const std::vector<Property>& materials) {
    Result<std::vector<Property>> kept = namedByOthers(database, id, materials);
    if (!kept) return std::move(kept).error();
    if (Result<void> done = database.execute("DELETE FROM material"); !done) return done;
    kept->insert(kept->begin(), materials.begin(), materials.end());
    std::int64_t position = 0;
    for (const Property& material : *kept)
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
