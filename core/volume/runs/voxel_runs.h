// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/run_volume.h"

#include <algorithm>
#include <span>

namespace burin {

// The paper's whole-voxel view of a line: a voxel has the property at its centre.

constexpr RunPosition centreOf(std::int32_t along) noexcept {
    return static_cast<RunPosition>(along) * unitsPerVoxel + unitsPerVoxel / 2;
}

/// The first voxel whose centre is not before a position.
constexpr std::int32_t firstVoxelFrom(RunPosition position) noexcept {
    return static_cast<std::int32_t>((position + unitsPerVoxel / 2 - 1) / unitsPerVoxel);
}

inline PropertyIndex propertyAt(std::span<const Segment> line, RunPosition position) noexcept {
    return std::ranges::partition_point(line, [=](Segment segment) { return segment.end() <= position; })->property();
}

/// Calls visit(Run) for each homogeneous run of a line in order, air included. No allocation.
template <class Visit>
void forEachVoxelRun(std::span<const Segment> line, Visit&& visit) {
    Run open{0, -1, airProperty};
    for (const Segment segment : line) {
        const std::int32_t next = firstVoxelFrom(segment.end());
        if (next <= open.last + 1) continue; // contains no voxel centre
        if (segment.property() != open.property && open.last >= open.first) {
            visit(static_cast<const Run&>(open));
            open.first = open.last + 1;
        }
        open.last = next - 1;
        open.property = segment.property();
    }
    visit(static_cast<const Run&>(open));
}

} // namespace burin
