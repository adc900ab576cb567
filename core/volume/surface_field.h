// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/surface.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace burin {

/// How full a workpiece is around one tile, on a lattice whose nodes are the centres of cells of 2^level voxels.
/// Along the runs a node's value is the exact share of solid within one cell to either side: around a face it falls
/// linearly over two cells, so that linear interpolation finds the face where the run ends. Across the runs values are
/// averaged 1-2-1, so that the stairs of slanting walls soften. Everything outside the grid is air.
///
/// Columns are counted within the window: column c stands at node `firstNode + c`. A tile owns `ownedU` × `ownedV`
/// columns from column `margin` on. Integers, so that neighbouring tiles find bit for bit the same.
class SurfaceField {
public:
    static constexpr int margin = 3;   ///< columns before and behind the owned ones
    static constexpr int overhang = 2; ///< nodes of an interval before and behind the blocks where the surface may be

    /// Stretch along the runs, of nodes.
    struct Interval {
        int first = 0, count = 0;    ///< a multiple of eight
        int owned = 0, ownedEnd = 0; ///< whose edges are drawn with it; a node more on either side is enough beyond
    };

    /// Call before the others.
    void aim(const VolumeSnapshot& workpiece, SurfaceTile tile, int level);
    /// Stretches outside which every column of the window is equal: no surface there. Looks at all runs of the tile.
    std::span<const Interval> findIntervals(const VolumeSnapshot& workpiece);
    /// Brick by brick of 32 voxels along the runs, wherever the surface is; level 0.
    static Interval brickInterval(const Grid& grid, std::int32_t brick);
    /// Works the nodes of one interval out; of a short one only those near its surface (`filled`).
    void fill(const VolumeSnapshot& workpiece, Interval interval);

    int cell() const { return 1 << level_; } ///< voxels
    int ownedU() const { return ownedU_; }
    int ownedV() const { return ownedV_; }
    int firstNodeU() const { return firstU_; }
    int firstNodeV() const { return firstV_; }
    Interval filled() const { return filled_; }
    /// Values of the nodes of a column, in the order of the runs; from column 1 to the last but one.
    const std::uint16_t* column(int u, int v) const { return smooth_.data() + offset(u, v); }
    /// A node with at least this value counts as inside.
    std::uint16_t half() const { return level_ == 0 ? 4096 : 16384; }
    /// The one material near the nodes that were filled in, airProperty when there are several.
    PropertyIndex onlyProperty() const;
    /// Whether one of them is protected.
    bool holdsProtected(const PropertyList& properties) const;

private:
    std::size_t offset(int u, int v) const {
        return static_cast<std::size_t>(u * columnsV_ + v) * static_cast<std::size_t>(filled_.count);
    }
    void mark(std::span<const Segment> line, RunPosition lineEnd);
    void markStretch(std::vector<std::uint8_t>& blocks, std::int64_t from, std::int64_t to) const;
    /// Of one column, in run units from the first node to be filled in.
    struct Stretch16 {
        std::int16_t low = 0, high = 0;
    };
    void fillShort(const VolumeSnapshot& workpiece);
    void fillLong(const VolumeSnapshot& workpiece);
    void narrow(int firstChange, int lastChange);
    void makeRoom();
    template <class Visit>
    void eachStretch(std::span<const Segment> line, Visit visit);
    void addStretch(RunPosition from, RunPosition to, std::span<int> sums) const;
    void smooth();

    int level_ = 0, ownedU_ = 0, ownedV_ = 0, firstU_ = 0, firstV_ = 0, columnsU_ = 0, columnsV_ = 0;
    std::array<bool, 256> seen_{}; ///< near the nodes that were filled in
    std::vector<std::uint8_t> solidBlocks_, airBlocks_;
    std::vector<Interval> intervals_;
    Interval filled_;
    std::vector<Stretch16> stretches_;
    std::vector<std::size_t> firstStretch_; ///< by column
    std::vector<std::uint16_t> raw_, smoothAlongV_, smooth_;
};

} // namespace burin
