// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/setup_id.h"
#include "core/document/database.h"
#include "core/document/kept_workpiece.h"
#include "core/recording/take_order.h"

#include <cstdint>
#include <vector>

namespace burin {

/// Computes a number that identifies the content of a setup's workpiece at any moment: part, stock and materials, and
/// what earlier recordings cut, with their tools. It does not depend on the order of the cuts, as removal is a union.
/// Recordings only grow and are never changed, so their length identifies their content. Reads the database once, for
/// all moments.
class CutDigest {
public:
    /// Errors: those of Database.
    static Result<CutDigest> of(Database& database, SetupId setup);

    std::int64_t at(const TakeMoment& moment) const noexcept;
    RecordedState state() const noexcept;
    const TakeOrder& order() const noexcept { return order_; }

private:
    struct Interval {
        std::uint64_t first = 0, end = 0; ///< samples
    };
    struct Take {
        std::int64_t id = 0;
        std::int64_t tool = 0; ///< digest of its id and its data
        std::uint64_t samples = 0;
        std::vector<Interval> undone, off;
    };
    static Result<std::vector<Interval>> intervalsOf(Database& database, const char* table, std::int64_t take);

    std::int64_t stock_ = 0;  ///< before any cut
    std::vector<Take> takes_; ///< in the order of recording
    TakeOrder order_;
};

} // namespace burin
