// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/part_field/cell_triangles.h"
#include "tests/part_field/made_brick.h"

namespace burin {

/// Cells of a brick in which no trilinear value is good enough: lists the triangles that are nearest to some point of
/// them. One thread each.
class ExactCellFinder {
public:
    /// What stays trilinear nevertheless, because more triangles may be nearest than a cell may name.
    struct Found {
        CellMask tooMany{}; ///< of the wanted cells
        float error = 0.0F; ///< of others where the surface folds, voxels: their samples say nothing of it
    };

    ExactCellFinder(const MeshDistance& part, const glm::dvec3& origin, double voxel) noexcept
        : triangles_(part, origin, voxel), voxel_(voxel) {}

    /// Of a brick's cells, replacing what it has. Cells beside those where the surface folds between samples (a slot, a
    /// rib or a pin of less than 2.5 voxels) come along as far as it does.
    /// @param corner  lowest, voxels from the origin  @param wanted  by what the samples say
    Found list(const glm::dvec3& corner, const CellMask& wanted, MadeBrick& made);
    /// The same, and every other cell in which the surface folds at all.
    Found listClosely(const glm::dvec3& corner, const CellMask& wanted, MadeBrick& made);
    /// Adds to a made brick cells where the surface folds between samples: some that are named, and those beside them.
    /// @return whether more cells turned out to be so
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

/// Cells of the brick that lies one brick along `step` (one axis, either way) from another, beside that one's.
CellMask cellsBeside(const CellMask& cells, const glm::ivec3& step) noexcept;

} // namespace burin
