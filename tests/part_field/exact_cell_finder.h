// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/part_field/cell_triangles.h"
#include "tests/part_field/made_brick.h"

namespace burin {

/// Finds the triangles that are nearest to some point of those cells of a brick in which no trilinear value is accurate
/// enough. Not thread-safe: use one object per thread.
class ExactCellFinder {
public:
    /// Cells that stay trilinear because more triangles may be nearest than a cell can list.
    struct Found {
        CellMask tooMany{}; ///< among the requested cells
        float error = 0.0F; ///< of other cells in which the surface folds, voxels: their samples do not show it
    };

    ExactCellFinder(const MeshDistance& part, const glm::dvec3& origin, double voxel) noexcept
        : triangles_(part, origin, voxel), voxel_(voxel) {}

    /// Lists the triangles of a brick's cells, replacing existing lists. Includes cells next to those where the surface
    /// folds between samples (a slot, a rib or a pin of less than 2.5 voxels), as far as the fold extends.
    /// @param corner lowest, voxels from the origin @param wanted cells selected by their samples
    Found list(const glm::dvec3& corner, const CellMask& wanted, MadeBrick& made);
    /// As `list`, and includes every other cell in which the surface folds at all.
    Found listClosely(const glm::dvec3& corner, const CellMask& wanted, MadeBrick& made);
    /// Adds cells where the surface folds between samples to a finished brick: the given ones and those next to them.
    /// @return whether more such cells were found
    bool grow(const glm::dvec3& corner, const CellMask& seeds, MadeBrick& made);

private:
    void begin(const glm::dvec3& corner, MadeBrick& made);
    void take(const CellMask& wanted, Found& found);
    void addFolded(CellMask cells, float cosine, bool spreads, Found& found);
    glm::dvec3 centreOf(int z, int place) const noexcept;
    void append(int z, int place, std::span<const std::uint32_t> list);
    void sortCells();

    CellTriangles triangles_;
    double voxel_;
    glm::dvec3 corner_{0.0};
    MadeBrick* made_ = nullptr;
    struct Listed {
        int cell;
        std::uint32_t list;
    };
    std::vector<Listed> listed_;
    std::size_t lastBegin_ = 0; ///< of the last list
};

/// The cells of a brick that touch the given cells of the adjacent brick, one brick along `step` (one axis, either
/// direction) from it.
CellMask cellsBeside(const CellMask& cells, const glm::ivec3& step) noexcept;

} // namespace burin
