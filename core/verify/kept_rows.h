// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/verify/row_replay.h"
#include "core/volume/runs/run_volume.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace burin {

/// What the moves of a replay did in each row of bricks, and what they left there: a row that the same moves come near
/// in the same order, from the same fresh workpiece and with the same tools, ends the same.
class KeptRows {
public:
    struct Row {
        std::vector<std::uint32_t> moves; ///< numbers (KnownMoves) of those that come near
        std::shared_ptr<const RowResult> result;
    };

    /// Returns the result in a row; null if other moves came near it, or none was kept.
    std::shared_ptr<const RowResult> find(std::size_t row, std::span<const std::uint32_t> moves) const {
        if (row >= rows_.size() || !std::ranges::equal(rows_[row].moves, moves)) return nullptr;
        return rows_[row].result;
    }
    const VolumeSnapshot& machined() const noexcept { return machined_; } ///< the workpiece after those moves

    void keep(std::vector<Row> rows, VolumeSnapshot machined) {
        rows_ = std::move(rows);
        machined_ = std::move(machined);
    }
    /// Of the rows alone: the workpiece is shared with whoever shows it.
    std::size_t bytes() const noexcept {
        std::size_t bytes = 0;
        for (const Row& row : rows_) {
            bytes += sizeof(Row) + row.moves.capacity() * sizeof(std::uint32_t);
            if (row.result) bytes += bytesOf(*row.result);
        }
        return bytes;
    }

private:
    static std::size_t bytesOf(const RowResult& result) noexcept {
        return sizeof(RowResult) + result.cuts.capacity() * sizeof(MoveUnits) +
               result.passes.capacity() * sizeof(StockPass) + result.contacts.capacity() * sizeof(StepContact) +
               result.grazed.capacity() * sizeof(GrazedLine) + result.steps.capacity() * sizeof(StepCut);
    }
    std::vector<Row> rows_;
    VolumeSnapshot machined_;
};

} // namespace burin
