// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/document/cut_digest.h"

#include "core/document/digest.h"
#include "core/document/stores.h"

#include <algorithm>

namespace burin {

Result<std::vector<CutDigest::Interval>> CutDigest::intervalsOf(Database& database, const char* table,
                                                                std::int64_t take) {
    Result<Statement> rows = Statement::prepare(database, std::string("SELECT first, count FROM ") + table +
                                                              " WHERE take = ? ORDER BY first");
    if (!rows) return std::move(rows).error();
    if (Result<void> bound = rows->bind(take); !bound) return std::move(bound).error();
    std::vector<Interval> intervals;
    Result<void> read = forEachRow(*rows, [&]() -> Result<void> {
        const auto first = static_cast<std::uint64_t>(rows->integer(0));
        intervals.push_back({first, first + static_cast<std::uint64_t>(rows->integer(1))});
        return {};
    });
    if (!read) return std::move(read).error();
    return intervals;
}

Result<CutDigest> CutDigest::of(Database& database, SetupId setup) {
    const std::string id = std::to_string(numberOf(setup));
    CutDigest made;
    const Result<std::int64_t> stock = digestOf(database, {{"model", "SELECT * FROM model"},
                                                           {"body", "SELECT * FROM body ORDER BY rowid"},
                                                           {"setup", "SELECT id, json FROM setup WHERE id = " + id},
                                                           {"material", "SELECT * FROM material ORDER BY rowid"}});
    if (!stock) return stock.error();
    made.stock_ = *stock;
    Result<Statement> rows =
        Statement::prepare(database, "SELECT id, tool_id, (SELECT json FROM tool WHERE tool.id = tool_id), " +
                                         std::string(sampleCountOfTake) +
                                         " FROM take WHERE removed = 0 AND setup = " + id + " ORDER BY id");
    if (!rows) return std::move(rows).error();
    Result<void> read = forEachRow(*rows, [&]() -> Result<void> {
        Digest tool;
        tool.add(rows->text(1));
        tool.add(rows->text(2));
        made.takes_.push_back({rows->integer(0), tool.value(), static_cast<std::uint64_t>(rows->integer(3)), {}, {}});
        return {};
    });
    if (!read) return std::move(read).error();
    for (Take& take : made.takes_) {
        Result<std::vector<Interval>> undone = intervalsOf(database, "undone_stretch", take.id);
        if (!undone) return std::move(undone).error();
        Result<std::vector<Interval>> off = intervalsOf(database, "switched_off_stretch", take.id);
        if (!off) return std::move(off).error();
        take.undone = std::move(*undone);
        take.off = std::move(*off);
    }
    Result<TakeOrder> order = loadTakeOrder(database, setup);
    if (!order) return std::move(order).error();
    made.order_ = std::move(*order);
    return made;
}

std::int64_t CutDigest::at(const TakeMoment& moment) const noexcept {
    Digest digest;
    digest.add(static_cast<std::uint64_t>(stock_));
    const std::size_t last = order_.placeOf(moment.take);
    for (const Take& take : takes_) {
        if (order_.placeOf(take.id) > last) continue;
        const std::uint64_t until = take.id == moment.take ? moment.samples : take.samples;
        digest.add(static_cast<std::uint64_t>(take.id));
        digest.add(static_cast<std::uint64_t>(take.tool));
        digest.add(until);
        for (const std::vector<Interval>* intervals : {&take.undone, &take.off}) {
            for (const Interval& interval : *intervals) {
                if (interval.first >= until) break;
                digest.add(interval.first);
                digest.add(std::min(interval.end, until));
            }
            digest.add(~std::uint64_t{0}); // not a valid sample: separates the lists
        }
    }
    return digest.value();
}

/// The digest includes the order, which decides which takes have ended at the moments between.
RecordedState CutDigest::state() const noexcept {
    TakeMoment end;
    for (const Take& take : takes_)
        if (order_.placeOf(take.id) > order_.placeOf(end.take)) end = {take.id, take.samples};
    Digest digest;
    digest.add(static_cast<std::uint64_t>(at(end)));
    for (const std::int64_t take : order_.takes()) digest.add(static_cast<std::uint64_t>(take));
    return {end, digest.value()};
}

} // namespace burin
