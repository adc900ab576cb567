// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/project/sample_chunk.h"
#include "core/project/stores.h"

#include <utility>

namespace burin {

namespace {

constexpr const char* selectTakes =
    "SELECT id, name, tool_id, allowance, tick_period, started_unix_time, stylus, complete, "
    "(SELECT COALESCE(SUM(count), 0) FROM sample_chunk WHERE take = take.id) FROM take";

TakeInfo infoOf(const Statement& row) {
    TakeInfo info;
    info.id = row.integer(0);
    info.name = row.text(1);
    info.toolId = row.text(2);
    info.allowance = row.real(3);
    info.tickPeriod = row.real(4);
    info.startedUnixTime = row.real(5);
    info.stylus = row.text(6);
    info.complete = row.integer(7) != 0;
    info.sampleCount = static_cast<std::uint64_t>(row.integer(8));
    return info;
}

Error unknownTake(Database& database, std::int64_t id) {
    const Result<std::vector<TakeInfo>> takes = loadTakes(database);
    if (!takes) return takes.error();
    if (takes->empty()) return {ErrorCode::projectIncomplete, "recording", "burin mill", database.subject()};
    std::string known;
    for (const TakeInfo& take : *takes) known.append(known.empty() ? "" : ", ").append(std::to_string(take.id));
    return {ErrorCode::nameUnknown, "take", std::to_string(id), known};
}

Result<void> loadSamples(Database& database, Take& take) {
    Result<Statement> rows =
        Statement::prepare(database, "SELECT first, count, samples FROM sample_chunk WHERE take = ? ORDER BY first");
    if (!rows) return std::move(rows).error();
    if (Result<void> bound = rows->bind(take.info.id); !bound) return bound;
    return forEachRow(*rows, [&]() -> Result<void> {
        const std::int64_t first = rows->integer(0), count = rows->integer(1);
        std::optional<std::vector<Sample>> samples;
        if (std::cmp_equal(first, take.samples.size()) && count >= 0)
            samples = decodeSamples(rows->blob(2), static_cast<std::size_t>(count));
        if (!samples)
            return damaged(database,
                           "take " + std::to_string(take.info.id) + ", sample " + std::to_string(take.samples.size()));
        take.samples.insert(take.samples.end(), samples->begin(), samples->end());
        return {};
    });
}

} // namespace

Result<std::int64_t> storeTake(Database& database, const TakeInfo& info) {
    if (Result<void> done =
            run(database,
                "INSERT INTO take(name, tool_id, allowance, tick_period, started_unix_time, stylus, complete) "
                "VALUES(?, ?, ?, ?, ?, ?, 0)",
                info.name, info.toolId, info.allowance, info.tickPeriod, info.startedUnixTime, info.stylus);
        !done)
        return std::move(done).error();
    return database.integer("SELECT last_insert_rowid()");
}

Result<std::vector<TakeInfo>> loadTakes(Database& database) {
    Result<Statement> rows = Statement::prepare(database, std::string(selectTakes) + " ORDER BY id");
    if (!rows) return std::move(rows).error();
    std::vector<TakeInfo> takes;
    Result<void> read = forEachRow(*rows, [&]() -> Result<void> {
        takes.push_back(infoOf(*rows));
        return {};
    });
    if (!read) return std::move(read).error();
    return takes;
}

Result<Take> loadTake(Database& database, std::int64_t id) {
    Take take;
    {
        Result<Statement> row = Statement::prepare(database, std::string(selectTakes) + " WHERE id = ?");
        if (!row) return std::move(row).error();
        if (Result<void> bound = row->bind(id); !bound) return std::move(bound).error();
        const Result<bool> found = row->step();
        if (!found) return found.error();
        if (!*found) return unknownTake(database, id);
        take.info = infoOf(*row);
    }
    if (Result<void> read = loadSamples(database, take); !read) return std::move(read).error();
    return take;
}

Result<void> eraseTake(Database& database, std::int64_t id) {
    Result<Statement> user = Statement::prepare(
        database, "SELECT name FROM path JOIN path_take ON path.id = path_take.path WHERE path_take.take = ?");
    if (!user) return std::move(user).error();
    if (Result<void> bound = user->bind(id); !bound) return bound;
    const Result<bool> used = user->step();
    if (!used) return used.error();
    if (*used)
        return Error{ErrorCode::argumentInvalid, "take", std::to_string(id),
                     "a take that no path uses (this one: " + std::string(user->text(0)) + ")"};
    if (Result<void> done = run(database, "DELETE FROM sample_chunk WHERE take = ?", id); !done) return done;
    if (Result<void> done = run(database, "DELETE FROM take WHERE id = ?", id); !done) return done;
    const Result<std::int64_t> erased = database.integer("SELECT changes()");
    if (!erased) return erased.error();
    if (*erased == 0) return unknownTake(database, id);
    return {};
}

} // namespace burin
