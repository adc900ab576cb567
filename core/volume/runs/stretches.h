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
struct Stretch {
    std::int64_t from = 0, to = 0;
};

inline bool sameGrid(const Grid& a, const Grid& b) noexcept {
    return a.low() == b.low() && a.edge() == b.edge() && a.count() == b.count() && a.axis() == b.axis();
}

/// Appends an interval that begins at or beyond the end of the last one; touching ones are merged.
inline void appendStretch(std::vector<Stretch>& stretches, Stretch next) {
    if (!stretches.empty() && stretches.back().to == next.from)
        stretches.back().to = next.to;
    else
        stretches.push_back(next);
}

/// The intervals of a line that are not air, in run units.
inline void materialUnits(std::span<const Segment> line, std::vector<Stretch>& stretches) {
    stretches.clear();
    RunPosition start = 0;
    for (const Segment segment : line) {
        if (segment.property() != airProperty) appendStretch(stretches, {start, segment.end()});
        start = segment.end();
    }
}

/// The intervals of a line that are not air, in whole voxels.
inline void materialVoxels(std::span<const Segment> line, std::vector<Stretch>& stretches) {
    stretches.clear();
    forEachVoxelRun(line, [&](const Run& run) {
        if (run.property != airProperty) appendStretch(stretches, {run.first, std::int64_t{run.last} + 1});
    });
}

} // namespace burin
