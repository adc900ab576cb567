// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/document/document_state.h"
#include "core/document/stores.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

namespace burin {

namespace {

using nlohmann::json;

std::string strokesText(const std::map<std::int64_t, std::size_t>& strokes) {
    json text = json::object();
    for (const auto& [take, count] : strokes) text[std::to_string(take)] = count;
    return text.dump();
}

std::optional<std::map<std::int64_t, std::size_t>> strokesOf(std::string_view text) {
    std::map<std::int64_t, std::size_t> strokes;
    const json record = json::parse(text, nullptr, false);
    if (!record.is_object()) return std::nullopt;
    for (const auto& [take, count] : record.items()) {
        if (!count.is_number_unsigned() || take.empty() || take.size() > 18 ||
            !std::ranges::all_of(take, [](char digit) { return digit >= '0' && digit <= '9'; }))
            return std::nullopt;
        strokes[std::stoll(take)] = count.get<std::size_t>();
    }
    return strokes;
}

Error damagedKept(const Database& database, const TakeMoment& at) {
    return damaged(database,
                   "kept_workpiece of take " + std::to_string(at.take) + ", sample " + std::to_string(at.samples));
}

constexpr std::int64_t mostKept = 64; ///< of a setup

/// Those that hold no more go first (undoing what made them so brings no one back then), else every other one.
Result<void> makeRoom(Database& database, SetupId setup) {
    const std::string of = " FROM kept_workpiece WHERE setup = " + std::to_string(numberOf(setup));
    const auto count = [&] { return database.integer(("SELECT COUNT(*)" + of).c_str()); };
    const Result<std::int64_t> all = count();
    if (!all) return all.error();
    if (*all < mostKept) return {};
    const Result<std::vector<TakeMoment>> holding = loadKeptMoments(database, setup);
    if (!holding) return holding.error();
    Result<Statement> rows = Statement::prepare(database, "SELECT take, samples" + of + " ORDER BY take, samples");
    if (!rows) return std::move(rows).error();
    std::vector<TakeMoment> gone;
    Result<void> read = forEachRow(*rows, [&]() -> Result<void> {
        const TakeMoment at{rows->integer(0), static_cast<std::uint64_t>(rows->integer(1))};
        if (std::ranges::find(*holding, at) == holding->end()) gone.push_back(at);
        return {};
    });
    if (!read) return read;
    if (gone.empty())
        for (std::size_t i = 0; i + 1 < holding->size(); i += 2) gone.push_back((*holding)[i]);
    for (const TakeMoment& at : gone)
        if (Result<void> done = run(database, "DELETE FROM kept_workpiece WHERE setup = ? AND take = ? AND samples = ?",
                                    numberOf(setup), at.take, at.samples);
            !done)
            return done;
    return {};
}

} // namespace

Result<RecordedState> loadRecordedState(Database& database, SetupId setup) {
    Result<Statement> row =
        Statement::prepare(database, "SELECT take, MAX(first + count) FROM sample_chunk WHERE take = "
                                     "(SELECT MAX(id) FROM take WHERE removed = 0 AND setup = ?) GROUP BY take");
    if (!row) return std::move(row).error();
    if (Result<void> bound = row->bind(numberOf(setup)); !bound) return std::move(bound).error();
    RecordedState state;
    Result<void> read = forEachRow(*row, [&]() -> Result<void> {
        state.end = {row->integer(0), static_cast<std::uint64_t>(row->integer(1))};
        return {};
    });
    if (!read) return std::move(read).error();
    const Result<std::int64_t> stock = stockDigest(database, setup);
    if (!stock) return stock.error();
    const Result<std::int64_t> digest = cutDigest(database, setup, *stock, state.end);
    if (!digest) return digest.error();
    state.digest = *digest;
    return state;
}

Result<void> storeKept(Database& database, SetupId setup, const KeptWorkpiece& kept, const RecordedState& madeIn) {
    if (Result<void> known = requireSetup(database, setup); !known) return known;
    const Result<RecordedState> now = loadRecordedState(database, setup);
    if (!now) return now.error();
    if (*now != madeIn) return {};
    if (Result<void> room = makeRoom(database, setup); !room) return room;
    const Result<std::int64_t> stock = stockDigest(database, setup);
    if (!stock) return stock.error();
    const Result<std::int64_t> madeOf = cutDigest(database, setup, *stock, kept.at);
    if (!madeOf) return madeOf.error();
    return run(database,
               "INSERT OR REPLACE INTO kept_workpiece(setup, take, samples, made_of, strokes, volume) "
               "VALUES(?, ?, ?, ?, ?, ?)",
               numberOf(setup), kept.at.take, kept.at.samples, *madeOf, strokesText(kept.strokes),
               BlobView{kept.volume});
}

Result<std::vector<TakeMoment>> loadKeptMoments(Database& database, SetupId setup) {
    Result<Statement> rows = Statement::prepare(
        database, "SELECT take, samples, made_of FROM kept_workpiece WHERE setup = ? ORDER BY take, samples");
    if (!rows) return std::move(rows).error();
    if (Result<void> bound = rows->bind(numberOf(setup)); !bound) return std::move(bound).error();
    const Result<std::int64_t> stock = stockDigest(database, setup);
    if (!stock) return stock.error();
    std::vector<TakeMoment> moments;
    Result<void> read = forEachRow(*rows, [&]() -> Result<void> {
        const TakeMoment at{rows->integer(0), static_cast<std::uint64_t>(rows->integer(1))};
        const Result<std::int64_t> madeOf = cutDigest(database, setup, *stock, at);
        if (!madeOf) return madeOf.error();
        if (*madeOf == rows->integer(2)) moments.push_back(at);
        return {};
    });
    if (!read) return std::move(read).error();
    return moments;
}

Result<KeptWorkpiece> loadKept(Database& database, SetupId setup, const TakeMoment& at) {
    Result<Statement> row = Statement::prepare(
        database, "SELECT strokes, volume FROM kept_workpiece WHERE setup = ? AND take = ? AND samples = ?");
    if (!row) return std::move(row).error();
    if (Result<void> bound = row->bind(numberOf(setup), at.take, at.samples); !bound) return std::move(bound).error();
    const Result<bool> found = row->step();
    if (!found) return found.error();
    if (!*found) return damagedKept(database, at);
    std::optional<std::map<std::int64_t, std::size_t>> strokes = strokesOf(row->text(0));
    if (!strokes) return damagedKept(database, at);
    return KeptWorkpiece{at, std::move(*strokes), std::string(row->blob(1))};
}

Result<void> eraseKeptFrom(Database& database, std::int64_t take) {
    return run(database, "DELETE FROM kept_workpiece WHERE take >= ?", take);
}

} // namespace burin
