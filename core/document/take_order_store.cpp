// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// The order of takes and the originals of copies: rows of `setup_setting` that exist only if takes were moved or
// copied.
#include "core/document/stores.h"

#include <algorithm>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <utility>

namespace burin {

namespace {

using nlohmann::json;

constexpr std::string_view orderRow = "take_order", copiesRow = "take_copies";

using CopiedTakes = std::map<std::int64_t, std::int64_t>; ///< the original of each copy

/// Whether a value can be the id of a take: an integer above 0.
bool isTakeId(const json& value) {
    constexpr std::uint64_t most = std::numeric_limits<std::int64_t>::max();
    return value.is_number_unsigned() && value.get<std::uint64_t>() > 0 && value.get<std::uint64_t>() <= most;
}

/// Empty if the text is not a list of distinct ids.
std::optional<std::vector<std::int64_t>> orderFromJson(std::string_view text) {
    const json list = json::parse(text, nullptr, false);
    if (!list.is_array() || !std::ranges::all_of(list, isTakeId)) return std::nullopt;
    std::vector<std::int64_t> order = list.get<std::vector<std::int64_t>>();
    if (std::set(order.begin(), order.end()).size() != order.size()) return std::nullopt;
    return order;
}

/// Empty unless each copy has a greater id than its original, which also excludes cycles.
std::optional<CopiedTakes> copiesFromJson(std::string_view text) {
    const json list = json::parse(text, nullptr, false);
    if (!list.is_array()) return std::nullopt;
    CopiedTakes copies;
    for (const json& pair : list) {
        if (!pair.is_array() || pair.size() != 2 || !std::ranges::all_of(pair, isTakeId)) return std::nullopt;
        const auto copy = pair[0].get<std::int64_t>(), original = pair[1].get<std::int64_t>();
        if (original >= copy || !copies.try_emplace(copy, original).second) return std::nullopt;
    }
    return copies;
}

Result<std::optional<std::string>> loadRow(Database& database, SetupId setup, std::string_view name) {
    Result<Statement> row = Statement::prepare(database, "SELECT json FROM setup_setting WHERE setup = ? AND name = ?");
    if (!row) return std::move(row).error();
    if (Result<void> bound = row->bind(numberOf(setup), name); !bound) return std::move(bound).error();
    const Result<bool> found = row->step();
    if (!found) return found.error();
    if (!*found) return std::optional<std::string>();
    return std::optional(std::string(row->text(0)));
}

Result<void> eraseRow(Database& database, SetupId setup, std::string_view name) {
    return run(database, "DELETE FROM setup_setting WHERE setup = ? AND name = ?", numberOf(setup), name);
}

Result<void> storeRow(Database& database, SetupId setup, std::string_view name, const std::string& text) {
    return run(database, "INSERT OR REPLACE INTO setup_setting(setup, name, json) VALUES(?, ?, ?)", numberOf(setup),
               name, text);
}

Result<CopiedTakes> loadCopies(Database& database, SetupId setup) {
    const Result<std::optional<std::string>> text = loadRow(database, setup, copiesRow);
    if (!text) return text.error();
    if (!*text) return CopiedTakes{};
    std::optional<CopiedTakes> copies = copiesFromJson(**text);
    if (!copies) return damaged(database, std::string(copiesRow));
    return std::move(*copies);
}

Result<void> storeCopies(Database& database, SetupId setup, const CopiedTakes& copies) {
    if (copies.empty()) return eraseRow(database, setup, copiesRow);
    json list = json::array();
    for (const auto& [copy, original] : copies) list.push_back({copy, original});
    return storeRow(database, setup, copiesRow, list.dump());
}

Result<void> noteCopy(Database& database, SetupId setup, std::int64_t copy, std::int64_t original) {
    Result<CopiedTakes> copies = loadCopies(database, setup);
    if (!copies) return std::move(copies).error();
    (*copies)[copy] = original;
    return storeCopies(database, setup, *copies);
}

Result<void> forgetInOrder(Database& database, SetupId setup, std::int64_t take) {
    const Result<std::optional<std::string>> text = loadRow(database, setup, orderRow);
    if (!text) return text.error();
    if (!*text) return {};
    std::optional<std::vector<std::int64_t>> order = orderFromJson(**text);
    if (!order || std::erase(*order, take) == 0) return {};
    return storeRow(database, setup, orderRow, json(*order).dump());
}

/// Returns all takes, including removed ones, in the order of recording.
Result<std::vector<std::int64_t>> recordedOrder(Database& database, SetupId setup) {
    Result<Statement> rows = Statement::prepare(database, "SELECT id FROM take WHERE setup = ? ORDER BY id");
    if (!rows) return std::move(rows).error();
    if (Result<void> bound = rows->bind(numberOf(setup)); !bound) return std::move(bound).error();
    std::vector<std::int64_t> takes;
    Result<void> read = forEachRow(*rows, [&]() -> Result<void> {
        takes.push_back(rows->integer(0));
        return {};
    });
    if (!read) return std::move(read).error();
    return takes;
}

bool contains(const std::vector<std::int64_t>& takes, std::int64_t take) {
    return std::ranges::find(takes, take) != takes.end();
}

} // namespace

Result<TakeOrder> loadTakeOrder(Database& database, SetupId setup) {
    const Result<std::vector<std::int64_t>> recorded = recordedOrder(database, setup);
    if (!recorded) return recorded.error();
    const Result<std::optional<std::string>> text = loadRow(database, setup, orderRow);
    if (!text) return text.error();
    if (!*text) return TakeOrder(*recorded);
    std::optional<std::vector<std::int64_t>> order = orderFromJson(**text);
    if (!order) return damaged(database, std::string(orderRow));
    std::erase_if(*order, [&](std::int64_t take) { return !contains(*recorded, take); }); // permanently deleted
    for (const std::int64_t take : *recorded)
        if (!contains(*order, take)) order->push_back(take); // recorded since
    return TakeOrder(std::move(*order));
}

Result<void> storeTakeOrder(Database& database, SetupId setup, const TakeOrder& wanted) {
    if (Result<void> known = requireSetup(database, setup); !known) return known;
    const Result<std::vector<std::int64_t>> recorded = recordedOrder(database, setup);
    if (!recorded) return recorded.error();
    std::set<std::int64_t> seen;
    for (const std::int64_t take : wanted.takes()) {
        if (!contains(*recorded, take)) return Error{ErrorCode::nameUnknown, "take", std::to_string(take), {}};
        if (!seen.insert(take).second)
            return Error{ErrorCode::argumentInvalid, "take", std::to_string(take), "each take once"};
    }
    std::vector<std::int64_t> order = wanted.takes();
    for (const std::int64_t take : *recorded)
        if (!seen.contains(take)) order.push_back(take);
    if (order == *recorded) return eraseRow(database, setup, orderRow);
    return storeRow(database, setup, orderRow, json(order).dump());
}

Result<std::int64_t> loadOriginal(Database& database, SetupId setup, std::int64_t take) {
    const Result<CopiedTakes> copies = loadCopies(database, setup);
    if (!copies) return copies.error();
    std::int64_t original = 0;
    for (auto copy = copies->find(take); copy != copies->end(); copy = copies->find(original)) original = copy->second;
    return original;
}

Result<void> forgetTake(Database& database, SetupId setup, std::int64_t take) {
    if (Result<void> done = forgetInOrder(database, setup, take); !done) return done;
    const Result<std::optional<std::string>> text = loadRow(database, setup, copiesRow);
    if (!text) return text.error();
    if (!*text) return {};
    std::optional<CopiedTakes> copies = copiesFromJson(**text);
    if (!copies) return {};
    const auto own = copies->find(take);
    if (own == copies->end()) return {};
    for (auto& [copy, original] : *copies)
        if (original == take) original = own->second;
    copies->erase(own);
    return storeCopies(database, setup, *copies);
}

Result<std::int64_t> copyTake(Database& database, std::int64_t id) {
    const Result<TakeOutline> original = loadTakeOutline(database, id);
    if (!original) return original.error();
    if (Result<void> done =
            run(database,
                "INSERT INTO take(name, tool_id, allowance, tick_period, started_unix_time, stylus, complete, setup) "
                "SELECT ?, tool_id, allowance, tick_period, started_unix_time, stylus, complete, setup "
                "FROM take WHERE id = ?",
                original->info.name + " (copy)", id);
        !done)
        return std::move(done).error();
    const Result<std::int64_t> copy = database.integer("SELECT last_insert_rowid()");
    if (!copy) return copy;
    for (const char* part :
         {"INSERT INTO take_material(take, property, material) SELECT ?, property, material FROM take_material "
          "WHERE take = ?",
          "INSERT INTO sample_chunk(take, first, count, samples) SELECT ?, first, count, samples FROM sample_chunk "
          "WHERE take = ? ORDER BY first",
          "INSERT INTO undone_stretch(take, first, count) SELECT ?, first, count FROM undone_stretch WHERE take = ?",
          "INSERT INTO switched_off_stretch(take, first, count) SELECT ?, first, count FROM switched_off_stretch "
          "WHERE take = ?"})
        if (Result<void> done = run(database, part, *copy, id); !done) return std::move(done).error();
    if (Result<void> noted = noteCopy(database, original->info.setup, *copy, id); !noted)
        return std::move(noted).error();
    return copy;
}

} // namespace burin
