// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/peers/octree_size.h"

#include "core/volume/runs/voxel_runs.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <vector>

namespace burin::benchmarks {

namespace {

/// An interval of cubes of one level on a line: up to `end`, all contain `value`.
struct Interval {
    std::int32_t end = 0;
    std::int32_t value = 0;
};
constexpr std::int32_t mixed = -1;

/// All lines of one level, one after another.
struct Level {
    std::int32_t side = 0; ///< cubes along an axis
    std::vector<Interval> intervals;
    std::vector<std::size_t> begin{0}; ///< of each line, and the end of the last

    void append(std::int32_t end, std::int32_t value) {
        const bool fresh = intervals.size() == begin.back();
        const std::int32_t reached = fresh ? 0 : intervals.back().end;
        if (end <= reached) return;
        if (!fresh && intervals.back().value == value)
            intervals.back().end = end;
        else
            intervals.push_back({end, value});
    }
    void endLine() { begin.push_back(intervals.size()); }
};

Level voxelsOf(const VolumeSnapshot& volume) {
    Level level;
    level.side = volume.grid().voxelsPerLine();
    for (std::int32_t v = 0; v < level.side; ++v)
        for (std::int32_t u = 0; u < level.side; ++u) {
            forEachVoxelRun(volume.line({u, v}), [&](const Run& run) { level.append(run.last + 1, run.property); });
            level.endLine();
        }
    return level;
}

/// Combines four adjacent lines into one of cubes with twice the edge.
void halveLine(const Level& fine, std::int32_t u, std::int32_t v, Level& coarse) {
    std::array<const Interval*, 4> at{};
    for (std::size_t i = 0; i < 4; ++i) {
        const auto row = static_cast<std::size_t>(2 * v + static_cast<std::int32_t>(i / 2));
        const auto column = static_cast<std::size_t>(2 * u + static_cast<std::int32_t>(i % 2));
        at[i] = fine.intervals.data() + fine.begin[row * static_cast<std::size_t>(fine.side) + column];
    }
    for (std::int32_t from = 0; from < fine.side;) {
        std::int32_t to = fine.side;
        bool equal = at[0]->value != mixed;
        for (const Interval* interval : at) {
            to = std::min(to, interval->end);
            equal = equal && interval->value == at[0]->value;
        }
        // The cube in which an interval begins is mixed unless the interval begins with it, and so is the one in which
        // it ends: the next interval, or the line's end, appends it.
        const std::int32_t whole = to / 2;
        if (equal) {
            coarse.append((from + 1) / 2, mixed);
            coarse.append(whole, at[0]->value);
        } else {
            coarse.append((to + 1) / 2, mixed);
        }
        for (const Interval*& interval : at)
            if (interval->end == to && to < fine.side) ++interval;
        from = to;
    }
    coarse.append(coarse.side, mixed);
    coarse.endLine();
}

Level halved(const Level& fine) {
    Level coarse;
    coarse.side = fine.side / 2;
    for (std::int32_t v = 0; v < coarse.side; ++v)
        for (std::int32_t u = 0; u < coarse.side; ++u) halveLine(fine, u, v, coarse);
    return coarse;
}

std::uint64_t mixedCubes(const Level& level) {
    std::uint64_t count = 0;
    for (std::size_t line = 0; line + 1 < level.begin.size(); ++line) {
        std::int32_t from = 0;
        for (std::size_t i = level.begin[line]; i < level.begin[line + 1]; ++i) {
            const Interval& interval = level.intervals[i];
            if (interval.value == mixed) count += static_cast<std::uint64_t>(interval.end - from);
            from = interval.end;
        }
    }
    return count;
}

} // namespace

std::uint64_t octreeBytes(const VolumeSnapshot& volume) {
    assert(volume.grid().lineCountU() == volume.grid().voxelsPerLine());
    Level level = halved(voxelsOf(volume)); // cubes of two voxels: mixed ones contain their voxels themselves
    std::uint64_t nodes = 1;
    while (level.side > 1) {
        level = halved(level);
        nodes += 8 * mixedCubes(level);
    }
    return 8 * nodes;
}

} // namespace burin::benchmarks
