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

/// Half-open stretch of a scanline inside a body.
struct InnerSpan {
    RunPosition from = 0, to = 0;
};

/// Turns the crossings of a line into the stretches inside, by the rules in voxelisation.h, and notes what was odd.
/// Keeps its working memory from line to line.
class LineFilling {
public:
    /// Run units that edges may gape or shells enter each other by and are still taken to meet.
    static constexpr std::int32_t slit = unitsPerVoxel / 16;

    explicit LineFilling(const Grid& grid) : grid_(grid) {}

    /// The commonest line: in and out again, within the grid. Nothing is odd about it.
    static bool isPlain(std::span<const LineCrossing> crossings, RunPosition lineEnd) noexcept {
        return crossings.size() == 2 && (crossings[0].isPlainEntry() & crossings[1].isPlainExit()) &&
               crossings[0].position() >= 0 && crossings[1].position() <= static_cast<std::int32_t>(lineEnd);
    }
    /// @param crossings in order, at least one
    /// @param open what closes the mesh; nullptr when it is closed
    /// @return in order, apart from each other; valid until the next call
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

/// Appends a line to a brick with `spans` of it painted over.
/// @param replaced gets what stood there
void appendPainted(std::span<const Segment> present, std::span<const InnerSpan> spans, PropertyIndex property,
                   BrickLines& lines, RunAmounts& replaced);

} // namespace burin
