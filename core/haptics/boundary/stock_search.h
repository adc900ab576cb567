// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cutting/cut_cache.h"
#include "core/cutting/occupied_bricks.h"
#include "core/geometry/box.h"
#include "core/geometry/piece_minimum.h"
#include "core/volume/runs/run_volume.h"

#include <cstdint>

namespace burin {

/// The point of the stock that is nearest to a piece of a tool.
struct NearStock {
    double distance = 0.0;    ///< mm, signed: negative inside the piece
    glm::dvec3 point{0.0};    ///< mm, on the centre line of a scanline
    glm::dvec3 gradient{0.0}; ///< of the piece's signed distance at the point
    LineIndex line;
    bool any = false;
};

/// Searches for the point of the machinable runs of a workpiece that is nearest to pieces of a tool. All coordinates in
/// the frame of the grid's lines (inLineFrame). The signed distance of a convex piece is convex, so a tangent bounds it
/// from below over any box: blocks and bricks of scanlines that hold nothing nearer are skipped, and where flat faces
/// are opposite each other the bound is exact. No allocation.
class StockSearch {
public:
    /// @param owed pending cuts, which count as removed; null: none
    /// @param visited is increased by the work done, in evaluations of a piece's distance
    /// @param within mm: only what is nearer is searched
    StockSearch(const RunVolume& workpiece, const CutCache* owed, OccupiedBricks& bricks, double within,
                std::uint64_t& visited) noexcept;

    /// Tries a scanline that is probably near, so that the rest of the search is short.
    void tryLine(const PlacedPiece& piece, LineIndex line) noexcept;
    /// Searches everything around a piece.
    void search(const PlacedPiece& piece) noexcept;
    const NearStock& nearest() const noexcept { return nearest_; }

private:
    struct Range {
        double low = 0.0, high = 0.0; ///< mm along the runs
    };
    Range within(const Box& reach) const noexcept;
    bool mayBeNearer(const PlacedPiece& piece, LineIndex first, LineIndex last, Range along) const noexcept;
    bool mayBeNearer(const PlacedPiece& piece, LineIndex first, LineIndex last, OccupiedBricks::Extent extent,
                     const Box& reach) const noexcept;
    void searchBrick(const PlacedPiece& piece, LineIndex first, LineIndex last, const Box& reach) noexcept;
    void searchLine(const PlacedPiece& piece, LineIndex line, const Box& reach) noexcept;
    void meet(const PlacedPiece& piece, LineIndex line, Range run) noexcept;

    const RunVolume& workpiece_;
    const CutCache* owed_;
    OccupiedBricks& bricks_;
    std::uint64_t& visited_;
    NearStock nearest_;
};

} // namespace burin
