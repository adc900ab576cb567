// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/brick_lines.h"
#include "core/volume/runs/run_volume.h"

#include <cstdint>
#include <vector>

namespace burin {

/// Length of material with its moments: integers, so that sums do not depend on their order.
struct UnitSum {
    std::uint64_t units = 0;   ///< run units
    std::uint64_t momentU = 0; ///< units times line along u
    std::uint64_t momentV = 0; ///< units times line along v
    std::uint64_t along = 0;   ///< units times (start + end), run units

    void add(const UnitSum& other) noexcept {
        units += other.units;
        momentU += other.momentU;
        momentV += other.momentV;
        along += other.along;
    }
    double volume(const Grid& grid) const noexcept { return static_cast<double>(units) * grid.unitVolume(); }
    glm::dvec3 centroid(const Grid& grid) const noexcept; ///< mm, setup frame; undefined for an empty sum
};

/// The machinable stock of one row of bricks (8 scanlines along v, all along u) while moves are cut out of it, in a
/// form that is quick to cut: for each line the topmost interval is stored apart from those below. The volume itself is
/// not changed meanwhile; `brick` returns its new content. Not thread-safe.
class RowStock {
public:
    /// @param row index of the row of bricks along v, from 0
    RowStock(const RunVolume& volume, std::int32_t row);

    const RunVolume& volume() const noexcept { return volume_; } ///< the volume before all cuts
    std::int32_t firstV() const noexcept { return firstV_; }
    std::int32_t lineCountV() const noexcept { return countV_; }
    std::int32_t brickCount() const noexcept { return bricks_; }

    /// Ends of the topmost machinable intervals of a row of lines (v from firstV on), u increasing, padded with 0 to
    /// whole bricks; 0 where a line has none.
    const std::int32_t* tops(std::int32_t v) const noexcept { return top_.data() + lineAt({0, v}); }
    /// Upper limit of the machinable intervals of a brick.
    std::int32_t brickTop(std::int32_t brick) const noexcept { return brickTop_[static_cast<std::size_t>(brick)]; }
    /// Upper limit of all material in a brick, machinable or not.
    std::int32_t brickReach(std::int32_t brick) const noexcept {
        return std::max(brickTop(brick), protectedTop_[static_cast<std::size_t>(brick)]);
    }
    /// Upper limit of all material in the whole row. Cost: visits each brick.
    std::int32_t reach() const noexcept;

    /// Removes the machinable stock between two positions of a line and adds it to `removed`.
    void cut(LineIndex line, RunPosition from, RunPosition to, UnitSum& removed);
    /// Updates the upper limit of a brick after cuts. Cost: its 64 lines.
    void settle(std::int32_t brick) noexcept;
    /// Adds what a line holds between two positions, machinable or not, to `sum` and returns its length.
    std::uint64_t overlap(LineIndex line, RunPosition from, RunPosition to, UnitSum& sum) const;

    /// Whether anything was removed from a brick.
    bool isCut(std::int32_t brick) const noexcept { return cut_[static_cast<std::size_t>(brick)]; }
    /// Returns all lines of a brick in their current state.
    void brick(std::int32_t brick, BrickLines& lines) const;

private:
    struct Interval {
        std::int32_t from = 0, to = 0;
    };
    std::size_t lineAt(LineIndex line) const noexcept {
        return static_cast<std::size_t>(line.v - firstV_) * width_ + static_cast<std::size_t>(line.u);
    }
    void read(LineIndex line, std::int32_t& brickProtected);
    void cutBelow(std::vector<Interval>& intervals, std::int32_t from, std::int32_t to, LineIndex line,
                  UnitSum& removed);
    void popTop(std::size_t at);
    /// Calls `visit(from, to)` for each machinable interval of a line, in ascending order.
    template <class Visit>
    void forEachInterval(std::size_t at, const Visit& visit) const {
        for (const Interval& interval : below_[at]) visit(interval.from, interval.to);
        if (top_[at] > 0) visit(base_[at], top_[at]);
    }

    const RunVolume& volume_;
    std::int32_t firstV_ = 0, countV_ = 0, bricks_ = 0;
    std::size_t width_ = 0; ///< lines along u, padded to whole bricks
    std::vector<std::int32_t> top_, base_;
    std::vector<std::vector<Interval>> below_; ///< of each line, ascending
    std::vector<std::int32_t> brickTop_, protectedTop_;
    std::vector<bool> cut_;
};

} // namespace burin
