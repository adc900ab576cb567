// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/clean_text.h"
#include "core/document/sample_chunk.h"
#include "core/document/stores.h"
#include "core/recording/sample_ranges.h"
#include "core/recording/tool_place.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace burin {

namespace {

constexpr std::int64_t mostSamples = std::int64_t{1} << 62; ///< so that the end of an interval does not overflow

// The valid values of a recording. Earlier versions stored any number, so others are clamped to the nearest valid one.
constexpr double shortestTick = 1e-5, longestTick = 1.0; // s
constexpr double latestTime = 1e11;                      // s

std::string selectTakes(const char* which) {
    return "SELECT id, name, tool_id, allowance, tick_period, started_unix_time, stylus, complete, setup, " +
           std::string(sampleCountOfTake) + " FROM take WHERE removed = 0 " + which;
}

double within(double value, double low, double high, double otherwise) {
    return std::isnan(value) ? otherwise : std::clamp(value, low, high);
}

TakeInfo infoOf(const Statement& row) {
    TakeInfo info;
    info.id = row.integer(0);
    info.name = cleanLine(row.text(1));
    info.toolId = cleanLine(row.text(2));
    info.allowance = within(row.real(3), 0.0, largestAllowance, 0.0);
    info.tickPeriod = within(row.real(4), shortestTick, longestTick, 0.001);
    info.startedUnixTime = within(row.real(5), 0.0, latestTime, 0.0);
    info.stylus = cleanLine(row.text(6));
    info.complete = row.integer(7) != 0;
    info.setup = SetupId{row.integer(8)};
    info.sampleCount = static_cast<std::uint64_t>(row.integer(9));
    return info;
}

Result<void> loadMaterialIds(Database& database, TakeInfo& info) {
    Result<Statement> rows =
        Statement::prepare(database, "SELECT property, material FROM take_material WHERE take = ? ORDER BY property");
    if (!rows) return std::move(rows).error();
    if (Result<void> bound = rows->bind(info.id); !bound) return bound;
    return forEachRow(*rows, [&]() -> Result<void> {
        if (std::cmp_not_equal(rows->integer(0), info.materials.size()))
            return damaged(database, "take " + std::to_string(info.id) + ", materials");
        info.materials.push_back(cleanLine(rows->text(1)));
        return {};
    });
}

/// Reads only the last chunk, as a take may be an hour long.
Result<void> loadSeconds(Database& database, TakeInfo& info) {
    Result<Statement> rows = Statement::prepare(
        database, "SELECT count, samples FROM sample_chunk WHERE take = ? ORDER BY first DESC LIMIT 1");
    if (!rows) return std::move(rows).error();
    if (Result<void> bound = rows->bind(info.id); !bound) return bound;
    info.seconds = 0.0;
    return forEachRow(*rows, [&]() -> Result<void> {
        const std::int64_t count = rows->integer(0);
        const std::optional<std::vector<Sample>> samples =
            count < 0 ? std::nullopt : decodeSamples(rows->blob(1), static_cast<std::size_t>(count));
        info.seconds.reset();
        if (samples && !samples->empty()) info.seconds = samples->back().time;
        return {};
    });
}

Error unknownTake(Database& database, std::int64_t id) {
    const Result<std::vector<TakeInfo>> takes = loadTakes(database);
    if (!takes) return takes.error();
    if (takes->empty()) return {ErrorCode::projectIncomplete, "recording", "burin mill", database.subject()};
    std::string known;
    for (const TakeInfo& take : *takes) known.append(known.empty() ? "" : ", ").append(std::to_string(take.id));
    return {ErrorCode::nameUnknown, "take", std::to_string(id), known};
}

/// Returns the setup of a take, also of a removed one; empty: no such take.
Result<std::optional<SetupId>> setupOfTake(Database& database, std::int64_t take) {
    Result<Statement> row = Statement::prepare(database, "SELECT setup FROM take WHERE id = ?");
    if (!row) return std::move(row).error();
    if (Result<void> bound = row->bind(take); !bound) return std::move(bound).error();
    const Result<bool> found = row->step();
    if (!found) return found.error();
    return *found ? std::optional(SetupId{row->integer(0)}) : std::nullopt;
}

/// An interval may extend beyond the samples: the rest was lost with its recorder.
Result<void> loadRanges(Database& database, const char* question, const char* what, std::int64_t id,
                        std::uint64_t samples, std::vector<SampleRange>& undone) {
    Result<Statement> rows = Statement::prepare(database, question);
    if (!rows) return std::move(rows).error();
    if (Result<void> bound = rows->bind(id); !bound) return bound;
    std::uint64_t end = 0;
    return forEachRow(*rows, [&]() -> Result<void> {
        const std::int64_t first = rows->integer(0), count = rows->integer(1);
        if (count <= 0 || count > mostSamples || first > mostSamples || std::cmp_less(first, end))
            return damaged(database, "take " + std::to_string(id) + ", " + what);
        const auto from = static_cast<std::uint64_t>(first);
        end = from + static_cast<std::uint64_t>(count);
        if (from < samples) undone.push_back({from, std::min(end, samples) - from});
        return {};
    });
}

/// Loads the samples that do not count, because they were undone or switched off.
Result<void> loadUndone(Database& database, TakeInfo& info, std::vector<SampleRange>& undone) {
    Result<std::vector<SampleRange>> back = loadTakenBack(database, info.id, info.sampleCount);
    if (!back) return std::move(back).error();
    undone = std::move(*back);
    Result<std::vector<SampleRange>> off = loadSwitchedOff(database, info.id, info.sampleCount);
    if (!off) return std::move(off).error();
    if (!off->empty()) {
        undone.insert(undone.end(), off->begin(), off->end());
        undone = joined(std::move(undone));
    }
    for (const SampleRange& range : undone) info.undoneCount += range.count;
    return {};
}

Result<void> loadCopyOf(Database& database, TakeInfo& info) {
    const Result<std::int64_t> original = loadOriginal(database, info.setup, info.id);
    if (!original) return original.error();
    info.copyOf = *original;
    return {};
}

/// Sorts the takes of each setup in its order, within the positions in the list that the setup's takes have.
Result<void> putInOrder(Database& database, std::vector<TakeInfo>& takes) {
    std::set<SetupId> setups;
    for (const TakeInfo& info : takes) setups.insert(info.setup);
    for (const SetupId setup : setups) {
        const Result<TakeOrder> order = loadTakeOrder(database, setup);
        if (!order) return order.error();
        std::vector<std::size_t> places;
        std::vector<TakeInfo> own;
        for (std::size_t i = 0; i < takes.size(); ++i) {
            if (takes[i].setup != setup) continue;
            places.push_back(i);
            own.push_back(takes[i]);
        }
        std::ranges::sort(own, {}, [&](const TakeInfo& info) { return order->placeOf(info.id); });
        for (std::size_t i = 0; i < own.size(); ++i) takes[places[i]] = std::move(own[i]);
    }
    return {};
}

} // namespace

Result<std::int64_t> storeTake(Database& database, const TakeInfo& info) {
    if (Result<void> known = requireSetup(database, info.setup); !known) return std::move(known).error();
    if (Result<void> done =
            run(database,
                "INSERT INTO take(name, tool_id, allowance, tick_period, started_unix_time, stylus, complete, setup) "
                "VALUES(?, ?, ?, ?, ?, ?, 0, ?)",
                info.name, info.toolId, info.allowance, info.tickPeriod, info.startedUnixTime, info.stylus,
                numberOf(info.setup));
        !done)
        return std::move(done).error();
    const Result<std::int64_t> id = database.integer("SELECT last_insert_rowid()");
    if (!id) return id;
    for (std::size_t property = 0; property < info.materials.size(); ++property)
        if (Result<void> done = run(database, "INSERT INTO take_material VALUES(?, ?, ?)", *id,
                                    static_cast<std::int64_t>(property), info.materials[property]);
            !done)
            return std::move(done).error();
    return id;
}

Result<std::vector<TakeInfo>> loadTakes(Database& database) {
    Result<Statement> rows = Statement::prepare(database, selectTakes("ORDER BY id"));
    if (!rows) return std::move(rows).error();
    std::vector<TakeInfo> takes;
    Result<void> read = forEachRow(*rows, [&]() -> Result<void> {
        takes.push_back(infoOf(*rows));
        return {};
    });
    if (!read) return std::move(read).error();
    if (read = putInOrder(database, takes); !read) return std::move(read).error();
    for (TakeInfo& info : takes) {
        std::vector<SampleRange> undone;
        if (read = loadUndone(database, info, undone); !read) return std::move(read).error();
        if (read = loadSeconds(database, info); !read) return std::move(read).error();
        if (read = loadMaterialIds(database, info); !read) return std::move(read).error();
        if (read = loadCopyOf(database, info); !read) return std::move(read).error();
    }
    return takes;
}

Result<TakeOutline> loadTakeOutline(Database& database, std::int64_t id) {
    TakeOutline outline;
    {
        Result<Statement> row = Statement::prepare(database, selectTakes("AND id = ?"));
        if (!row) return std::move(row).error();
        if (Result<void> bound = row->bind(id); !bound) return std::move(bound).error();
        const Result<bool> found = row->step();
        if (!found) return found.error();
        if (!*found) return unknownTake(database, id);
        outline.info = infoOf(*row);
    }
    if (Result<void> read = loadUndone(database, outline.info, outline.undone); !read) return std::move(read).error();
    if (Result<void> read = loadSeconds(database, outline.info); !read) return std::move(read).error();
    if (Result<void> read = loadMaterialIds(database, outline.info); !read) return std::move(read).error();
    if (Result<void> read = loadCopyOf(database, outline.info); !read) return std::move(read).error();
    return outline;
}

Result<void> visitSamples(Database& database, std::int64_t id, const SampleVisitor& visit) {
    Result<Statement> rows =
        Statement::prepare(database, "SELECT first, count, samples FROM sample_chunk WHERE take = ? "
                                     "AND EXISTS(SELECT 1 FROM take WHERE id = sample_chunk.take AND removed = 0) "
                                     "ORDER BY first");
    if (!rows) return std::move(rows).error();
    if (Result<void> bound = rows->bind(id); !bound) return bound;
    std::uint64_t visited = 0;
    Result<void> done = forEachRow(*rows, [&]() -> Result<void> {
        const std::int64_t first = rows->integer(0), count = rows->integer(1);
        std::optional<std::vector<Sample>> samples;
        if (std::cmp_equal(first, visited) && count >= 0)
            samples = decodeSamples(rows->blob(2), static_cast<std::size_t>(count));
        const auto damagedAt = [&](std::uint64_t sample) {
            return damaged(database, "take " + std::to_string(id) + ", sample " + std::to_string(sample));
        };
        if (!samples) return damagedAt(visited);
        for (std::size_t i = 0; i < samples->size(); ++i)
            if (!isToolPlace((*samples)[i].proxy)) return damagedAt(visited + i);
        visited += samples->size();
        return visit(*samples);
    });
    if (!done || visited > 0) return done;
    Result<TakeOutline> empty = loadTakeOutline(database, id); // checks whether it exists at all
    return empty ? Result<void>() : std::move(empty).error();
}

Result<Sample> loadSample(Database& database, std::int64_t take, std::uint64_t index) {
    Result<Statement> rows = Statement::prepare(database, "SELECT first, count, samples FROM sample_chunk "
                                                          "WHERE take = ? AND first <= ? ORDER BY first DESC LIMIT 1");
    if (!rows) return std::move(rows).error();
    if (Result<void> bound = rows->bind(take, index); !bound) return std::move(bound).error();
    std::optional<std::vector<Sample>> samples;
    std::uint64_t first = 0;
    Result<void> read = forEachRow(*rows, [&]() -> Result<void> {
        first = static_cast<std::uint64_t>(rows->integer(0));
        samples = decodeSamples(rows->blob(2), static_cast<std::size_t>(std::max<std::int64_t>(0, rows->integer(1))));
        if (samples) return {};
        return damaged(database, "take " + std::to_string(take) + ", sample " + std::to_string(first));
    });
    if (!read) return std::move(read).error();
    if (samples && index - first < samples->size()) return (*samples)[index - first];
    return Error{ErrorCode::argumentInvalid, "sample", std::to_string(index), "one of take " + std::to_string(take)};
}

Result<Take> loadTake(Database& database, std::int64_t id) {
    Result<TakeOutline> outline = loadTakeOutline(database, id);
    if (!outline) return std::move(outline).error();
    Take take{std::move(outline->info), {}, std::move(outline->undone)};
    Result<void> read = visitSamples(database, id, [&take](std::span<const Sample> samples) -> Result<void> {
        take.samples.insert(take.samples.end(), samples.begin(), samples.end());
        return {};
    });
    if (!read) return std::move(read).error();
    return take;
}

Result<void> hideTake(Database& database, std::int64_t id) {
    if (Result<void> unused = requireUnused(database, {id}); !unused) return unused;
    const Result<TakeOutline> known = loadTakeOutline(database, id);
    if (!known) return known.error();
    return run(database, "UPDATE take SET removed = 1 WHERE id = ?", id);
}

Result<void> showTake(Database& database, std::int64_t id) {
    if (Result<void> done = run(database, "UPDATE take SET removed = 0 WHERE id = ? AND removed = 1", id); !done)
        return done;
    const Result<std::int64_t> shown = database.integer("SELECT changes()");
    if (!shown) return shown.error();
    return *shown == 0 ? Result<void>(unknownTake(database, id)) : Result<void>();
}

Result<void> eraseHiddenTakes(Database& database, std::optional<SetupId> setup) {
    Result<Statement> rows =
        Statement::prepare(database, "SELECT id FROM take WHERE removed = 1 AND setup = COALESCE(?, setup)");
    if (!rows) return std::move(rows).error();
    if (Result<void> bound = rows->bind(setup ? std::optional(numberOf(*setup)) : std::nullopt); !bound) return bound;
    std::vector<std::int64_t> hidden;
    Result<void> read = forEachRow(*rows, [&]() -> Result<void> {
        hidden.push_back(rows->integer(0));
        return {};
    });
    for (const std::int64_t id : hidden)
        if (read) read = eraseTake(database, id);
    return read;
}

Result<void> storeMarkers(Database& database, SetupId setup, std::span<const TimeMarker> markers) {
    if (Result<void> known = requireSetup(database, setup); !known) return known;
    if (Result<void> done = run(database, "DELETE FROM marker WHERE setup = ?", numberOf(setup)); !done) return done;
    for (const TimeMarker& marker : markers)
        if (Result<void> done =
                run(database, "INSERT OR REPLACE INTO marker(setup, take, samples, name) VALUES(?, ?, ?, ?)",
                    numberOf(setup), marker.at.take, marker.at.samples, marker.name);
            !done)
            return done;
    return {};
}

Result<std::vector<TimeMarker>> loadMarkers(Database& database, SetupId setup) {
    Result<Statement> rows = Statement::prepare(database, "SELECT take, samples, name FROM marker WHERE setup = ?");
    if (!rows) return std::move(rows).error();
    if (Result<void> bound = rows->bind(numberOf(setup)); !bound) return std::move(bound).error();
    std::vector<TimeMarker> markers;
    Result<void> read = forEachRow(*rows, [&]() -> Result<void> {
        if (rows->integer(1) < 0) return damaged(database, "marker");
        markers.push_back({{rows->integer(0), static_cast<std::uint64_t>(rows->integer(1))}, cleanLine(rows->text(2))});
        return {};
    });
    if (!read) return std::move(read).error();
    const Result<TakeOrder> order = loadTakeOrder(database, setup);
    if (!order) return order.error();
    std::ranges::sort(
        markers, [&](const TakeMoment& one, const TakeMoment& other) { return order->isBefore(one, other); },
        &TimeMarker::at);
    return markers;
}

Result<void> eraseTake(Database& database, std::int64_t id) {
    if (Result<void> unused = requireUnused(database, {id}); !unused) return unused;
    const Result<std::optional<SetupId>> setup = setupOfTake(database, id);
    if (!setup) return setup.error();
    if (!*setup) return unknownTake(database, id);
    if (Result<void> done = forgetTake(database, **setup, id); !done) return done;
    if (Result<void> done = eraseKeptFrom(database, id); !done) return done;
    for (const char* table : {"DELETE FROM sample_chunk WHERE take = ?", "DELETE FROM undone_stretch WHERE take = ?",
                              "DELETE FROM switched_off_stretch WHERE take = ?", "DELETE FROM marker WHERE take = ?",
                              "DELETE FROM take_material WHERE take = ?"})
        if (Result<void> done = run(database, table, id); !done) return done;
    return run(database, "DELETE FROM take WHERE id = ?", id);
}

Result<void> storeUndone(Database& database, std::int64_t take, const SampleRange& interval) {
    const auto refused = [&] {
        return Error{ErrorCode::argumentInvalid, "stretch",
                     std::to_string(interval.first) + " + " + std::to_string(interval.count),
                     "samples of take " + std::to_string(take) + " that were not taken back yet"};
    };
    if (interval.count == 0 || std::cmp_greater(interval.first, mostSamples) ||
        std::cmp_greater(interval.count, mostSamples))
        return refused();
    const Result<std::vector<TakeInfo>> takes = loadTakes(database);
    if (!takes) return takes.error();
    if (std::ranges::none_of(*takes, [&](const TakeInfo& info) { return info.id == take; }))
        return unknownTake(database, take);
    // Not clipped, as the take may still grow.
    const Result<std::vector<SampleRange>> undone = loadTakenBack(database, take, ~std::uint64_t{0});
    if (!undone) return undone.error();
    for (const SampleRange& other : *undone)
        if (other.contains(interval.first) || interval.contains(other.first)) return refused();
    return run(database, "INSERT INTO undone_stretch(take, first, count) VALUES(?, ?, ?)", take, interval.first,
               interval.count);
}

Result<std::vector<SampleRange>> loadTakenBack(Database& database, std::int64_t take, std::uint64_t samples) {
    std::vector<SampleRange> undone;
    Result<void> read = loadRanges(database, "SELECT first, count FROM undone_stretch WHERE take = ? ORDER BY first",
                                   "undone samples", take, samples, undone);
    if (!read) return std::move(read).error();
    return undone;
}

Result<std::vector<SampleRange>> loadSwitchedOff(Database& database, std::int64_t take, std::uint64_t samples) {
    std::vector<SampleRange> off;
    Result<void> read =
        loadRanges(database, "SELECT first, count FROM switched_off_stretch WHERE take = ? ORDER BY first",
                   "samples that are switched off", take, samples, off);
    if (!read) return std::move(read).error();
    return off;
}

Result<void> storeSwitchedOff(Database& database, std::int64_t take, std::span<const SampleRange> off) {
    const Result<TakeOutline> known = loadTakeOutline(database, take);
    if (!known) return known.error();
    if (Result<void> done = run(database, "DELETE FROM switched_off_stretch WHERE take = ?", take); !done) return done;
    std::uint64_t end = 0;
    for (const SampleRange& range : off) {
        if (range.count == 0 || range.first < end || range.first >= known->info.sampleCount ||
            range.count > known->info.sampleCount - range.first)
            return Error{ErrorCode::argumentInvalid, "stretch",
                         std::to_string(range.first) + " + " + std::to_string(range.count),
                         "samples of take " + std::to_string(take)};
        end = range.first + range.count;
        if (Result<void> done = run(database, "INSERT INTO switched_off_stretch(take, first, count) VALUES(?, ?, ?)",
                                    take, range.first, range.count);
            !done)
            return done;
    }
    return {};
}

Result<void> renameTake(Database& database, std::int64_t take, const std::string& name) {
    const Result<TakeOutline> known = loadTakeOutline(database, take);
    if (!known) return known.error();
    return run(database, "UPDATE take SET name = ? WHERE id = ?", name, take);
}

Result<void> eraseUndone(Database& database, std::int64_t take, const SampleRange& interval) {
    if (Result<void> done = run(database, "DELETE FROM undone_stretch WHERE take = ? AND first = ? AND count = ?", take,
                                interval.first, interval.count);
        !done)
        return done;
    const Result<std::int64_t> erased = database.integer("SELECT changes()");
    if (!erased) return erased.error();
    if (*erased == 0)
        return Error{ErrorCode::argumentInvalid, "stretch",
                     std::to_string(interval.first) + " + " + std::to_string(interval.count),
                     "samples of take " + std::to_string(take) + " that are undone"};
    return {};
}

} // namespace burin
