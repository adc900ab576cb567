// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/document/cut_digest.h"
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

constexpr std::size_t mostKept = 64; ///< for each setup

/// Returns all stored workpieces, in order, and whether each is still valid.
Result<std::vector<std::pair<TakeMoment, bool>>> allKept(Database& database, SetupId setup, const CutDigest& digest) {
    Result<Statement> rows =
        Statement::prepare(database, "SELECT take, samples, made_of FROM kept_workpiece WHERE setup = ?");
    if (!rows) return std::move(rows).error();
    if (Result<void> bound = rows->bind(numberOf(setup)); !bound) return std::move(bound).error();
    std::vector<std::pair<TakeMoment, bool>> all;
    Result<void> read = forEachRow(*rows, [&]() -> Result<void> {
        const TakeMoment at{rows->integer(0), static_cast<std::uint64_t>(rows->integer(1))};
        all.emplace_back(at, digest.at(at) == rows->integer(2));
        return {};
    });
    if (!read) return std::move(read).error();
    std::ranges::sort(
        all, [&](const TakeMoment& one, const TakeMoment& other) { return digest.order().isBefore(one, other); },
        &std::pair<TakeMoment, bool>::first);
    return all;
}

/// If there are too many, deletes those that are no longer valid; if all are valid, every other one except the newest.
Result<void> makeRoom(Database& database, SetupId setup, const CutDigest& digest) {
    const auto all = allKept(database, setup, digest);
    if (!all) return all.error();
    if (all->size() < mostKept) return {};
    const bool allHold = std::ranges::all_of(*all, [](const auto& each) { return each.second; });
    for (std::size_t i = 0; i < all->size(); ++i) {
        const auto& [at, holds] = (*all)[i];
        const bool stays = allHold ? (all->size() - i) % 2 == 1 : holds;
        if (stays) continue;
        if (Result<void> done = run(database, "DELETE FROM kept_workpiece WHERE setup = ? AND take = ? AND samples = ?",
                                    numberOf(setup), at.take, at.samples);
            !done)
            return done;
    }
    return {};
}

} // namespace

Result<RecordedState> loadRecordedState(Database& database, SetupId setup) {
    const Result<CutDigest> digest = CutDigest::of(database, setup);
    if (!digest) return digest.error();
    return digest->state();
}

Result<void> storeKept(Database& database, SetupId setup, const KeptWorkpiece& kept, const RecordedState& madeIn) {
    if (Result<void> known = requireSetup(database, setup); !known) return known;
    const Result<CutDigest> digest = CutDigest::of(database, setup);
    if (!digest) return digest.error();
    if (digest->state() != madeIn) return {};
    if (Result<void> room = makeRoom(database, setup, *digest); !room) return room;
    return run(database,
               "INSERT OR REPLACE INTO kept_workpiece(setup, take, samples, made_of, strokes, volume) "
               "VALUES(?, ?, ?, ?, ?, ?)",
               numberOf(setup), kept.at.take, kept.at.samples, digest->at(kept.at), strokesText(kept.strokes),
               BlobView{kept.volume});
}

Result<std::vector<TakeMoment>> loadKeptMoments(Database& database, SetupId setup) {
    const Result<CutDigest> digest = CutDigest::of(database, setup);
    if (!digest) return digest.error();
    const auto all = allKept(database, setup, *digest);
    if (!all) return all.error();
    std::vector<TakeMoment> moments;
    for (const auto& [at, holds] : *all)
        if (holds) moments.push_back(at);
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
