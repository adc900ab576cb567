// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/grid.h"
#include "core/volume/voxelisation/crossing_cells.h"
#include "core/volume/voxelisation/open_mesh.h"
#include "core/volume/voxelisation/voxelisation.h"

#include <span>
#include <vector>

namespace burin {

/// Half-open interval of a scanline inside a body.
struct InnerSpan {
    RunPosition from = 0, to = 0;
};

/// Turns the crossings of a line into the intervals inside the body, by the rules in voxelisation.h, and reports
/// irregularities. Keeps its working memory from line to line.
class LineFilling {
public:
    /// Gap between edges, or overlap of shells, in run units, up to which they are still considered to touch.
    static constexpr std::int32_t slit = unitsPerVoxel / 16;

    explicit LineFilling(const Grid& grid) : grid_(grid) {}

    /// The most common line: one entry and one exit, within the grid. It has no irregularity.
    static bool isPlain(std::span<const LineCrossing> crossings, RunPosition lineEnd) noexcept {
        return crossings.size() == 2 && (crossings[0].isPlainEntry() & crossings[1].isPlainExit()) &&
               crossings[0].position() >= 0 && crossings[1].position() <= static_cast<std::int32_t>(lineEnd);
    }
    /// @param crossings in order, at least one
    /// @param open  what closes the mesh; nullptr if it is closed
    /// @return intervals in order, disjoint and not touching; valid until the next call
    std::span<const InnerSpan> spans(std::span<const LineCrossing> crossings, LineIndex line, const OpenMesh* open,
                                     VoxelisationReport& report);

private:
    void byWinding(std::span<const LineCrossing> crossings);
    void byParity(std::span<const LineCrossing> crossings);
    void throughHoles(std::span<const LineCrossing> crossings, LineIndex line, const OpenMesh& open);
    void add(LineCrossing from, LineCrossing to);
    void noteOverlaps(std::span<const LineCrossing> crossings, LineIndex line, DoubtfulLines& overlaps) const;
    void doubt(std::span<const LineCrossing> crossings, LineIndex line, DoubtfulLines& doubtful) const;
    Box placeOf(std::span<const LineCrossing> crossings, LineIndex line) const;

    Grid grid_;
    std::vector<InnerSpan> spans_;
};

/// Appends a line to a brick with its parts in `spans` set to `property`.
/// @param replaced  receives the amounts of what was there before
void appendPainted(std::span<const Segment> present, std::span<const InnerSpan> spans, PropertyIndex property,
                   BrickLines& lines, RunAmounts& replaced);

} // namespace burin
