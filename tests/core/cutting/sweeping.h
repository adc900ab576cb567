// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cutting/line_frame.h"
#include "core/cutting/pose_steps.h"
#include "core/tool/swept_span.h"
#include "core/volume/runs/run_volume.h"
#include "tests/core/cutting/workpieces.h"

#include <span>

namespace burin::tests {

/// Removes the volume swept by pieces on a straight step: line by line over the whole grid, so that only the spans
/// themselves are under test.
inline void sweep(RunVolume& volume, std::span<const RevolvedPiece> pieces, const PoseStep& step, RunAmounts& removed) {
    const Grid& grid = volume.grid();
    for (const RevolvedPiece& piece : pieces) {
        const SweptPiece swept(piece, inLineFrame(grid, step.fromTip), inLineFrame(grid, step.toTip),
                               inLineFrame(grid, step.axis));
        for (LineIndex line; line.v < grid.lineCountV(); ++line.v)
            for (line.u = 0; line.u < grid.lineCountU(); ++line.u) {
                const glm::dvec2 centre = grid.lineCentre(line);
                const std::optional<Span> span = swept.along(centre.x, centre.y);
                if (!span) continue;
                const RunPosition from = grid.toRunPosition(span->low), to = grid.toRunPosition(span->high);
                if (from < to) (void)volume.removeSpan(line, from, to, removed);
            }
    }
}

inline std::uint64_t totalOf(const RunAmounts& amounts) {
    std::uint64_t total = 0;
    for (std::size_t i = 1; i < amounts.units.size(); ++i) total += amounts.units[i];
    return total;
}

/// A grid with any axis of its runs, filled with one material.
inline RunVolume solid(const glm::dvec3& low, double edge, const glm::ivec3& count, RunAxis axis) {
    return block(Grid::make(low, edge, count, axis).value());
}

} // namespace burin::tests
