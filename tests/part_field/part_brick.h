// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/part_field/exact_cell_finder.h"

#include <bitset>
#include <optional>
#include <vector>

namespace burin {

/// Whether lines are so smooth that cubics between their ends do.
bool isSmooth(const LineCheck& check) noexcept;

/// Whether they may do, provided that the middle between them is asked, too: of lines a brick long.
bool mayBeSmooth(const LineCheck& check) noexcept;
/// Whether a sample is what was expected there.
bool agrees(const DistanceSample& expected, const DistanceSample& asked) noexcept;

/// What samples between such lines are off by, voxels.
struct LineError {
    float even = 0.0F;   ///< where the surface bends evenly along them
    float kinked = 0.0F; ///< and so much more where a line has one kink: facets of the mesh as wide as half of it
};
LineError lineError(const LineCheck& check) noexcept;

/// Makes fine bricks: samples, their packed form, the bound of their error and the cells that need more than samples.
/// One thread each.
class BrickMaker {
public:
    static constexpr float bandVoxels = 4.0F;

    BrickMaker(const MeshDistance& part, const glm::dvec3& origin, double voxel)
        : asker_(part, origin, voxel), exact_(part, origin, voxel), voxel_(voxel) {}

    /// @param corner  lowest, voxels from the origin  @param third  its samples 4 voxels apart
    /// @param thirdError  of those: none where they were asked for
    void make(const glm::ivec3& corner, const SampleGrid& third, const LineError& thirdError, MadeBrick& made);
    /// Asks the mesh for every sample, and looks into every cell for folds of the surface.
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
    float sampleError_ = 0.0F; ///< of samples that were not asked for, voxels
    CellMask mask_{};
};

} // namespace burin
