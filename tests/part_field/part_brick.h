// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/part_field/exact_cell_finder.h"

#include <bitset>
#include <optional>
#include <vector>

namespace burin {

/// Whether lines are so smooth that cubics between their ends are accurate enough.
bool isSmooth(const LineCheck& check) noexcept;

/// Whether they may be accurate enough for lines one brick long, provided that the centre between them is sampled too.
bool mayBeSmooth(const LineCheck& check) noexcept;
/// Whether a sample agrees with the expected one.
bool agrees(const DistanceSample& expected, const DistanceSample& asked) noexcept;

/// Errors of samples interpolated between such lines, voxels.
struct LineError {
    float even = 0.0F;   ///< where the curvature of the surface is even along them
    float kinked = 0.0F; ///< additional error where a line has one kink: facets of the mesh as wide as half of it
};
LineError lineError(const LineCheck& check) noexcept;

/// Makes fine bricks: samples, their packed form, the bound of their error and the cells that need more than samples.
/// Not thread-safe: use one object per thread.
class BrickMaker {
public:
    static constexpr float bandVoxels = 4.0F;

    BrickMaker(const MeshDistance& part, const glm::dvec3& origin, double voxel)
        : asker_(part, origin, voxel), exact_(part, origin, voxel), voxel_(voxel) {}

    /// @param corner lowest, voxels from the origin @param third its samples 4 voxels apart
    /// @param thirdError error of those; zero where they were sampled from the mesh
    void make(const glm::ivec3& corner, const SampleGrid& third, const LineError& thirdError, MadeBrick& made);
    /// Samples every point from the mesh, and examines every cell for folds of the surface.
    void makeClosely(const glm::ivec3& corner, MadeBrick& made);

private:
    LineError sample(const SampleGrid& third);
    void finish(MadeBrick& made, bool closely);
    void sampleFailing();
    void askBeside(std::vector<std::size_t> asked, std::bitset<CellGrid::samples>& onLines);
    std::optional<DistanceSample> between(const glm::ivec3& sample) const noexcept;
    float boundCells();
    float cellError(int x, int y, int z) const noexcept;
    float errorOf(const CellMask& cells) const noexcept;
    void pack(MadeBrick& made) const;
    void packResiduals(MadeBrick& made, const std::array<float, CellGrid::samples>& residuals, float half) const;

    PartAsker asker_;
    ExactCellFinder exact_;
    double voxel_;
    glm::dvec3 corner_{0.0};
    SampleGrid five_{5}, nine_{9};
    float sampleError_ = 0.0F; ///< of samples that were not taken from the mesh, voxels
    CellMask mask_{};
};

} // namespace burin
