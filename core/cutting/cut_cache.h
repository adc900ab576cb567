// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/vectorised.h"
#include "core/cutting/removed_units.h"
#include "core/cutting/write_queue.h"
#include "core/tool/span_rows.h"
#include "core/volume/runs/run_volume.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace burin {

/// A cache of the scanlines around a tool, for fast access in each tick. For each line it holds the gap, an interval in
/// which nothing machinable is left, and the segments that border it on either side. A span that grows the gap within
/// these neighbours is removed by arithmetic on many lines at a time, without reading the volume; other spans read the
/// volume's line. Removed material is a pending write to the volume until it is written, a brick of 8 × 8 lines at a
/// time, within 16 ticks. Memory: 16 bytes a line, toroidal: a brick of lines replaces another that the tool has left
/// behind. Only on the workpiece's writer thread, including the queries (`owed`, `visitAround`).
class CutCache {
public:
    static constexpr int brickInLines = 8; ///< cost of reading a brick at once and preparing its first cut, in lines

    /// Allocates. @param reach largest distance of a cut from the tool's tip, in lines, including the move
    CutCache(const Grid& grid, double reach);

    /// Number of groups of eight lines, or of rows divided by eight, that fit into the cache at once.
    std::int32_t side() const noexcept { return static_cast<std::int32_t>(side_); }
    /// Makes sure that the lines of some rows and groups of eight are in the cache; pending writes of the lines that
    /// they replace are written. @return number of bricks that were not in the cache before; empty if reserved memory
    /// ran out, in which case nothing is lost
    std::optional<int> cover(RunVolume& workpiece, std::int32_t firstRow, std::int32_t lastRow, std::int32_t firstGroup,
                             std::int32_t lastGroup) noexcept;
    /// Removes the spans of rows that share their bricks. Stops at a brick for which no memory is left: see
    /// RemovedUnits.
    /// @return number of lines for which the volume was read; a brick read at once counts as `brickInLines`
    int take(RunVolume& workpiece, std::span<const RowSpans> rows, RemovedUnits& removed) noexcept;
    /// Adds the sums of `take` so far; call after its last row.
    void collect(RemovedUnits& removed) noexcept;
    /// Prepares bricks that a cut may soon need. @return as `take`
    int look(const RunVolume& workpiece, const RowSpans& row) noexcept;

    /// Number of bricks that `writeDue` would write now; the more is taken before, the greater it is.
    std::uint32_t writesDue() const noexcept { return queue_.pace(); }
    /// Call once a tick: writes the bricks that are due, at an even pace. Returns false if out of reserved memory.
    bool writeDue(RunVolume& workpiece) noexcept;
    /// Writes everything that is pending. Returns false if out of reserved memory; the remaining writes are still
    /// pending.
    bool writeAll(RunVolume& workpiece) noexcept;
    bool owesNothing() const noexcept { return queue_.empty(); }
    /// Forgets all lines and their pending writes.
    void forget() noexcept;

    /// An interval whose machinable runs are removed, though the volume may still show them; empty if nothing is
    /// pending.
    struct Owed {
        RunPosition from = 0, to = 0;
    };
    Owed owed(LineIndex line) const noexcept {
        const auto brick = brickAt(line.u >> 3, line.v >> 3);
        const Brick& found = bricks_[brick];
        if (found.u != line.u >> 3 || found.v != line.v >> 3 || !(found.owing >> bitOf(line) & 1)) return {};
        const LineGap gap = gaps_[brick].at(bitOf(line));
        return {static_cast<RunPosition>(gap.low), static_cast<RunPosition>(gap.high)};
    }

    /// Calls `visit(property, start, end)` for the remaining machinable material of a line between two positions, if
    /// the line's gap and its neighbours determine it completely. Returns false if they do not.
    template <class Visit>
    bool visitAround(LineIndex line, RunPosition from, RunPosition to, Visit&& visit) const noexcept {
        const std::size_t place = brickAt(line.u >> 3, line.v >> 3);
        const Brick& brick = bricks_[place];
        if (brick.u != line.u >> 3 || brick.v != line.v >> 3 || !brick.known) return false;
        const LineGap gap = gaps_[place].at(bitOf(line));
        const auto low = static_cast<RunPosition>(gap.low), high = static_cast<RunPosition>(gap.high);
        const std::uint32_t left = gap.left, right = gap.right;
        if (from < (left != 0 ? left >> 8 : low) || to > (right != 0 ? right >> 8 : high)) return false;
        const auto property = [](std::uint32_t neighbour) { return static_cast<PropertyIndex>(neighbour & 255U); };
        if (from < low) visit(property(left), from, to < low ? to : low);
        if (to > high) visit(property(right), from > high ? from : high, to);
        return true;
    }

    /// The gap of a line, run units, and the machinable segments that border it.
    struct LineGap {
        std::int32_t low = 0, high = 0; ///< low > high: not known yet
        std::uint32_t left = 0;         ///< start << 8 | property, of the segment that ends at `low`; 0: none
        std::uint32_t right = 0;        ///< end << 8 | property, of the segment that begins at `high`; 0: none
    };
    /// The gaps of a brick, line 8 v + u.
    struct alignas(64) Gaps {
        std::array<std::int32_t, 64> low, high;
        std::array<std::uint32_t, 64> left, right;

        LineGap at(std::size_t line) const noexcept { return {low[line], high[line], left[line], right[line]}; }
        void set(std::size_t line, const LineGap& gap) noexcept {
            low[line] = gap.low;
            high[line] = gap.high;
            left[line] = gap.left;
            right[line] = gap.right;
        }
    };
    /// Sums over some rows; the rows of lines alternate between the two halves of the lanes.
    struct alignas(64) Sums {
        template <class Number>
        using Lanes = std::array<Number, 16>;
        std::array<Lanes<std::int32_t>, 256> byProperty{};
        Lanes<float> units{}, momentU{}, momentV{}, momentAlong{}; ///< relative to the origins
        std::array<std::uint64_t, 4> used{};                       ///< a bit for each property
        std::int32_t originU = 0, originV = 0;                     ///< lines
        std::int32_t alongOrigin = 0;                              ///< run units, doubled
        int rows = 0;                                              ///< number of rows in the sums
    };
    /// 8 × 8 lines.
    struct alignas(64) Brick {
        std::int32_t u = -1, v = -1;
        std::uint64_t owing = 0; ///< a bit for each line
        BrickRoom room;
        bool ready = false; ///< ready for cuts: in the queue, and with reserved room
        bool known = false; ///< its lines were read
    };
    /// A row of bricks with the spans to be removed from it.
    struct BrickRow {
        Gaps* gaps = nullptr;
        Brick* bricks = nullptr;
        std::uint32_t mask = 0;              ///< mask of a brick's position in the row
        std::int32_t firstLine = 0;          ///< along v
        std::int32_t first = 0, end = 0;     ///< requested bricks
        EightIntegers begins{}, ends{};      ///< of each row of lines
        const BrickOfSpans* spans = nullptr; ///< of the first brick

        /// Bits of the requested rows of lines of a brick.
        std::uint32_t asked(std::int32_t brick) const noexcept {
            return bitsOf((load(begins) <= integers(brick)) & (load(ends) > integers(brick)));
        }
    };
    /// Lines of a brick that require reading the volume.
    struct Open {
        std::int32_t brick = 0, row = 0; ///< along u; of lines, in the brick
        std::uint32_t lanesOf = 0;       ///< bits of those lines
    };

private:
    struct Bounds {
        std::int32_t low = 0, high = 0; ///< run units
    };
    /// A gap as found in the volume.
    struct Found : LineGap {
        std::uint64_t taken = 0; ///< run units
    };
    static std::size_t bitOf(LineIndex line) noexcept {
        return static_cast<std::size_t>((line.v & 7) * 8 + (line.u & 7));
    }
    std::size_t brickAt(std::int32_t u, std::int32_t v) const noexcept {
        return static_cast<std::size_t>(v & mask_) * side_ + static_cast<std::size_t>(u & mask_);
    }
    void claim(Brick& brick, std::int32_t u, std::int32_t v) noexcept;
    bool expectCuts(RunVolume& workpiece, Brick& brick) noexcept;
    BrickRow brickRow(std::span<const RowSpans> rows) noexcept;
    int know(const RunVolume& workpiece, Brick& brick, const BrickOfSpans& spans, std::uint32_t rows) noexcept;
    void learn(const RunVolume& workpiece, Brick& brick, std::int32_t place) noexcept;
    std::uint32_t placeOf(const Brick& brick) const noexcept {
        return static_cast<std::uint32_t>(&brick - bricks_.data());
    }
    Gaps& gapsOf(const Brick& brick) noexcept { return gaps_[placeOf(brick)]; }
    int takeSome(RunVolume& workpiece, std::span<const RowSpans> rows, RemovedUnits& removed) noexcept;
    int takeOpen(RunVolume& workpiece, const BrickRow& row, std::span<const Open> open, RemovedUnits& removed) noexcept;
    bool write(RunVolume& workpiece, Brick& brick) noexcept;
    bool writeNext(RunVolume& workpiece) noexcept;
    bool widen(RunVolume& workpiece, LineIndex line, Brick& brick, Bounds span, RemovedUnits& removed) noexcept;
    static Found lookAround(const RunVolume& workpiece, LineIndex line, Bounds around, Bounds span,
                            RemovedUnits& removed) noexcept;

    std::int32_t lineCountU_, lineCountV_;
    std::size_t side_ = 0;   ///< bricks
    std::int32_t mask_ = 0;  ///< mask of a brick's position
    std::vector<Gaps> gaps_; ///< of the bricks
    std::vector<Brick> bricks_;
    WriteQueue queue_; ///< of all bricks with pending writes, by their positions
    std::int32_t coveredFirstRow_ = 0, coveredLastRow_ = -1, coveredFirstGroup_ = 0, coveredLastGroup_ = -1;

    std::vector<Open> open_; ///< of the rows that are being taken
    Sums sums_;
    int mostRows_ = 1; ///< number of rows before the sums could overflow
};

} // namespace burin
