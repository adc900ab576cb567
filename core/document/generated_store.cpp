// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/clean_text.h"
#include "core/document/generated_chunk.h"
#include "core/document/stores.h"

#include <algorithm>
#include <span>
#include <utility>

namespace burin {

namespace {

constexpr const char* selectGenerated =
    "SELECT id, setup, name, tool_id, allowance, "
    "(SELECT COALESCE(SUM(count), 0) FROM generated_chunk WHERE generated = generated.id), request FROM generated";

/// A table counts rows from 1; the ids of generated moves of a project are negative.
std::int64_t rowOf(std::int64_t id) noexcept {
    return -id;
}

GeneratedInfo generatedInfoOf(const Statement& row) {
    GeneratedInfo info;
    info.id = -row.integer(0);
    info.setup = SetupId{row.integer(1)};
    info.name = cleanLine(row.text(2));
    info.toolId = cleanLine(row.text(3));
    info.allowance = row.real(4);
    info.pointCount = static_cast<std::uint64_t>(row.integer(5));
    info.request = cleanLine(row.text(6));
    return info;
}

std::string partOf(std::int64_t id) {
    return "generated moves " + std::to_string(rowOf(id));
}

Result<void> storeStroke(Database& database, std::int64_t row, std::int64_t stroke,
                         std::span<const GeneratedPoint> points) {
    for (std::size_t first = 0; first < points.size(); first += pointsPerChunk) {
        const auto part = points.subspan(first, std::min(pointsPerChunk, points.size() - first));
        const std::string packed = encodePoints(part);
        if (Result<void> done =
                run(database, "INSERT INTO generated_chunk VALUES(?, ?, ?, ?, ?)", row, stroke,
                    static_cast<std::int64_t>(first), static_cast<std::int64_t>(part.size()), BlobView{packed});
            !done)
            return done;
    }
    return {};
}

/// Returns the stroke that a chunk continues, or a new one; null: the chunk does not fit there.
std::vector<GeneratedPoint>* placeFor(GeneratedMoves& moves, std::int64_t stroke, std::int64_t first) {
    const auto begun = static_cast<std::int64_t>(moves.strokes.size());
    if (first == 0 && stroke == begun) return &moves.strokes.emplace_back();
    if (stroke + 1 != begun || static_cast<std::int64_t>(moves.strokes.back().size()) != first) return nullptr;
    return &moves.strokes.back();
}

Result<void> loadStrokes(Database& database, GeneratedMoves& moves) {
    Result<Statement> rows =
        Statement::prepare(database, "SELECT stroke, first, count, points FROM generated_chunk WHERE generated = ? "
                                     "ORDER BY stroke, first");
    if (!rows) return std::move(rows).error();
    if (Result<void> bound = rows->bind(rowOf(moves.info.id)); !bound) return bound;
    return forEachRow(*rows, [&]() -> Result<void> {
        const std::int64_t count = rows->integer(2);
        const auto points = count > 0 ? decodePoints(rows->blob(3), static_cast<std::size_t>(count)) : std::nullopt;
        std::vector<GeneratedPoint>* const stroke = placeFor(moves, rows->integer(0), rows->integer(1));
        if (!points || stroke == nullptr) return damaged(database, partOf(moves.info.id));
        stroke->insert(stroke->end(), points->begin(), points->end());
        return {};
    });
}

} // namespace

Result<std::int64_t> storeGenerated(Database& database, const GeneratedMoves& moves, SetupId setup) {
    if (Result<void> valid = checkGenerated(moves); !valid) return std::move(valid).error();
    if (Result<void> known = requireSetup(database, setup); !known) return std::move(known).error();
    if (Result<void> done =
            run(database, "INSERT INTO generated(setup, name, tool_id, allowance, request) VALUES(?, ?, ?, ?, ?)",
                numberOf(setup), moves.info.name, moves.info.toolId, moves.info.allowance, moves.info.request);
        !done)
        return std::move(done).error();
    const Result<std::int64_t> row = database.integer("SELECT last_insert_rowid()");
    if (!row) return row;
    for (std::size_t stroke = 0; stroke < moves.strokes.size(); ++stroke)
        if (Result<void> done = storeStroke(database, *row, static_cast<std::int64_t>(stroke), moves.strokes[stroke]);
            !done)
            return std::move(done).error();
    return -*row;
}

Result<std::vector<GeneratedInfo>> loadGenerated(Database& database) {
    Result<Statement> rows = Statement::prepare(database, std::string(selectGenerated) + " ORDER BY id");
    if (!rows) return std::move(rows).error();
    std::vector<GeneratedInfo> generated;
    Result<void> read = forEachRow(*rows, [&]() -> Result<void> {
        generated.push_back(generatedInfoOf(*rows));
        return {};
    });
    if (!read) return std::move(read).error();
    return generated;
}

Result<GeneratedMoves> loadGeneratedMoves(Database& database, std::int64_t id) {
    const Result<std::vector<GeneratedInfo>> known = loadGenerated(database);
    if (!known) return known.error();
    const auto found = std::ranges::find(*known, id, &GeneratedInfo::id);
    if (found == known->end()) return Error{ErrorCode::nameUnknown, "generated moves", std::to_string(id), {}};
    GeneratedMoves moves{*found, {}};
    if (Result<void> read = loadStrokes(database, moves); !read) return std::move(read).error();
    if (!checkGenerated(moves)) return damaged(database, partOf(id));
    return moves;
}

Result<void> eraseGenerated(Database& database, std::int64_t id) {
    if (Result<void> unused = requireUnused(database, {id}); !unused) return unused;
    for (const char* erase : {"DELETE FROM generated_chunk WHERE generated = ?", "DELETE FROM generated WHERE id = ?"})
        if (Result<void> done = run(database, erase, rowOf(id)); !done) return done;
    const Result<std::int64_t> changed = database.integer("SELECT changes()");
    if (!changed) return changed.error();
    if (*changed == 0) return Error{ErrorCode::nameUnknown, "generated moves", std::to_string(id), {}};
    return {};
}

} // namespace burin
