// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/surface/surface.h"

#include <algorithm>

namespace burin {

/// The part of a surface that is computed at once: a tile of scanlines, and of these a piece along the runs. It is
/// sampled on a lattice whose nodes are the centres of cells of 2^level voxels. Columns count along u, rows along v,
/// nodes along the runs; node n of column c in row r is cell (firstU + c, firstV + r, firstNode + n) of the grid. A
/// window owns the edges that start at its own nodes; around those is a margin that other windows own.
struct SurfaceWindow {
    static constexpr int margin = 3;                                     ///< columns and rows on either side
    static constexpr int marginNodes = 2;                                ///< nodes on either side
    static constexpr int mostColumns = linesPerSurfaceTile + 2 * margin; ///< rows alike
    static constexpr int ownedNodes = linesPerSurfaceTile;               ///< of a brick

    int level = 0;
    int firstU = 0, firstV = 0, firstNode = 0;
    int columns = 0, rows = 0;
    int owned = 0; ///< nodes, from node `marginNodes` on

    /// Number of cells that cover a number of voxels.
    static int cells(int voxels, int level) { return (voxels + (1 << level) - 1) >> level; }
    /// Number of windows of a tile along the runs.
    static int count(const Grid& grid, int level) {
        return (cells(grid.voxelsPerLine(), level) + ownedNodes - 1) / ownedNodes;
    }
    /// @param piece along the runs, from 0
    static SurfaceWindow of(const Grid& grid, SurfaceTile tile, int piece, int level) {
        const int tileCells = linesPerSurfaceTile >> level;
        SurfaceWindow window;
        window.level = level;
        window.firstU = tileCells * tile.u - margin;
        window.firstV = tileCells * tile.v - margin;
        window.columns = std::min(tileCells, cells(grid.lineCountU(), level) - tileCells * tile.u) + 2 * margin;
        window.rows = std::min(tileCells, cells(grid.lineCountV(), level) - tileCells * tile.v) + 2 * margin;
        // The surface closes before the first voxel.
        const int begin = piece == 0 ? -1 : piece * ownedNodes;
        window.firstNode = begin - marginNodes;
        window.owned = std::min((piece + 1) * ownedNodes, cells(grid.voxelsPerLine(), level)) - begin;
        return window;
    }
    int cell() const { return 1 << level; } ///< voxels
    int nodes() const { return owned + 2 * marginNodes; }
};

} // namespace burin
