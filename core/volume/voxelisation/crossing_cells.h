// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/brick_lines.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace burin {

/// Where the centre line of a scanline passes through a triangle. Ordered by position; at equal positions entering
/// comes first.
class LineCrossing {
public:
    LineCrossing() = default;
    /// @param position  run units, from -1 (anywhere below the grid) to one beyond the line's end
    /// @param leaves    whether a line that runs upwards leaves an outward-oriented mesh here
    /// @param cap       whether the triangle only closes a hole
    LineCrossing(std::int32_t position, bool leaves, bool cap) noexcept
        : code_(static_cast<std::uint32_t>(position + 1) << 2 | (leaves ? 2U : 0U) | (cap ? 1U : 0U)) {}
    std::int32_t position() const noexcept { return static_cast<std::int32_t>(code_ >> 2) - 1; }
    /// The change of the winding number in upward direction.
    std::int32_t turn() const noexcept { return (code_ & 2U) != 0 ? -1 : 1; }
    bool cap() const noexcept { return (code_ & 1U) != 0; }
    bool isPlainEntry() const noexcept { return (code_ & 3U) == 0; } ///< of surface
    bool isPlainExit() const noexcept { return (code_ & 3U) == 2; }
    friend auto operator<=>(LineCrossing, LineCrossing) = default;

private:
    std::uint32_t code_ = 0;
};

/// Crossings of the scanlines of one row of bricks. Each line has a cell with room for a few, so that most crossings
/// are written to their line directly; the surplus is kept separately. Can be reused row after row without allocating.
class CrossingCells {
public:
    explicit CrossingCells(std::int32_t lineCountU)
        : cells_(static_cast<std::size_t>((lineCountU + brickSide - 1) / brickSide) * linesPerBrick)
        , touched_(cells_.size() / linesPerBrick) {}

    /// The cell of a line. @param v within the row of bricks, 0 … 7
    static std::uint32_t cellOf(std::int32_t u, std::int32_t v) noexcept {
        const auto column = static_cast<std::uint32_t>(u), row = static_cast<std::uint32_t>(v);
        return column / brickSide * linesPerBrick + row * brickSide + column % brickSide;
    }
    void add(std::uint32_t index, LineCrossing crossing) {
        touched_[index / linesPerBrick] = 1;
        Cell& cell = cells_[index];
        const std::uint32_t at = cell.count++;
        if (at < room)
            cell.crossings[at] = crossing;
        else
            surplus_.push_back({index, crossing});
    }
    bool touched(std::int32_t column) const noexcept { return touched_[static_cast<std::size_t>(column)] != 0; }
    /// To be called between the last `add` and the first `take`.
    void finish() { std::ranges::sort(surplus_, {}, &Surplus::cell); }
    /// Returns the crossings of a line of a brick in order; its cell is empty afterwards. Valid until the next call.
    std::span<const LineCrossing> take(std::int32_t column, int line) {
        const std::size_t index = static_cast<std::size_t>(column) * linesPerBrick + static_cast<std::size_t>(line);
        Cell& cell = cells_[index];
        const std::uint32_t count = std::exchange(cell.count, 0);
        if (count > room) return takeMany(index);
        const std::span<LineCrossing> found = std::span(cell.crossings).first(count);
        if (count == 2) {
            if (found[1] < found[0]) std::swap(found[0], found[1]);
        } else if (count > 2) {
            std::ranges::sort(found);
        }
        return found;
    }
    /// Marks the cells of a brick as empty.
    void leave(std::int32_t column) noexcept { touched_[static_cast<std::size_t>(column)] = 0; }
    /// Marks all cells as empty.
    void clear() noexcept { surplus_.clear(); }

private:
    static constexpr std::uint32_t room = 7;
    struct alignas(32) Cell {
        std::uint32_t count = 0;
        std::array<LineCrossing, room> crossings{};
    };
    struct Surplus {
        std::uint32_t cell = 0;
        LineCrossing crossing;
    };

    std::span<const LineCrossing> takeMany(std::size_t index) {
        const auto [first, last] =
            std::ranges::equal_range(surplus_, static_cast<std::uint32_t>(index), {}, &Surplus::cell);
        many_.assign(cells_[index].crossings.begin(), cells_[index].crossings.end());
        for (auto at = first; at != last; ++at) many_.push_back(at->crossing);
        std::ranges::sort(many_);
        return many_;
    }

    std::vector<Cell> cells_;           ///< by brick, then by line within the brick
    std::vector<std::uint8_t> touched_; ///< by brick
    std::vector<Surplus> surplus_;
    std::vector<LineCrossing> many_;
};

} // namespace burin
