// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/run_volume.h"
#include "core/volume/runs/voxel_runs.h"

#include <algorithm>
#include <span>
#include <vector>

namespace burin {

/// Half-open interval of one scanline, in run units or in voxels.
struct Interval {
    std::int64_t from = 0, to = 0;
};

inline bool sameGrid(const Grid& a, const Grid& b) noexcept {
    return a.low() == b.low() && a.edge() == b.edge() && a.count() == b.count() && a.axis() == b.axis();
}

/// Appends an interval that begins at or beyond the end of the last one; touching ones are merged.
inline void appendInterval(std::vector<Interval>& intervals, Interval next) {
    if (!intervals.empty() && intervals.back().to == next.from)
        intervals.back().to = next.to;
    else
        intervals.push_back(next);
}

/// The intervals of a line that are not air, in run units.
inline void materialUnits(std::span<const Segment> line, std::vector<Interval>& intervals) {
    intervals.clear();
    RunPosition start = 0;
    for (const Segment segment : line) {
        if (segment.property() != airProperty) appendInterval(intervals, {start, segment.end()});
        start = segment.end();
    }
}

/// The intervals of a line that are not air, in whole voxels.
inline void materialVoxels(std::span<const Segment> line, std::vector<Interval>& intervals) {
    intervals.clear();
    forEachVoxelRun(line, [&](const Run& run) {
        if (run.property != airProperty) appendInterval(intervals, {run.first, std::int64_t{run.last} + 1});
    });
}

} // namespace burin
