// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/field/part_sample.h"

#include <optional>

namespace burin {

/// A fine brick as it leaves its maker; the builder puts the parts together.
struct MadeBrick {
    FineBrick header;
    std::array<std::int8_t, CellGrid::samples> narrow{}; ///< residuals, unless they are wide
    std::vector<std::int16_t> wide;
    std::array<std::uint64_t, 8> exactMask{};
    std::vector<std::uint32_t> cellLists; ///< per exact cell: where its list begins in `lists`
    std::vector<std::uint32_t> lists;
    float bound = 0.0F;           ///< mm
    float least = 0.0F;           ///< mm
    std::uint32_t bandVoxels = 0; ///< its own samples (all but those on the upper faces) within the band
};

/// What a made brick answers where its cells are trilinear, mm. @param place  voxels from its lowest corner, 0 … 8
float distanceIn(const MadeBrick& made, const glm::vec3& place) noexcept;
/// Whether the place is in an exact cell.
bool isExactIn(const MadeBrick& made, const glm::vec3& place) noexcept;

/// The largest difference, mm, between the samples that two bricks share. @param axis  along which the second is the
/// next
float disagreement(const MadeBrick& first, const MadeBrick& second, int axis) noexcept;

/// Whether lines are so smooth that cubics between their ends do.
bool isSmooth(const LineCheck& check) noexcept;

/// Whether they may do, provided that the middle between them is asked, too: of lines a brick long.
bool mayBeSmooth(const LineCheck& check) noexcept;
/// Whether a sample is what was expected there.
bool agrees(const PartSample& expected, const PartSample& asked) noexcept;

/// What samples between such lines are off by, voxels.
float interpolationError(const LineCheck& check) noexcept;

/// Makes fine bricks: samples, their packed form, the bound of their error and the cells that need more than samples.
/// One thread each.
class BrickMaker {
public:
    static constexpr float bandVoxels = 4.0F;

    BrickMaker(const MeshDistance& part, const glm::dvec3& origin, double voxel)
        : part_(part), asker_(part, origin, voxel), origin_(origin), voxel_(voxel) {}

    /// @param corner  lowest, voxels from the origin  @param third  its samples 4 voxels apart
    /// @param thirdError  of those, voxels
    void make(const glm::ivec3& corner, const SampleGrid& third, float thirdError, MadeBrick& made);
    /// Asks the mesh for every sample.
    void make(const glm::ivec3& corner, MadeBrick& made);

private:
    void sample(const SampleGrid& third);
    void finish(MadeBrick& made);
    void sampleFailing();
    std::optional<PartSample> onLines(const glm::ivec3& sample) const noexcept;
    float boundCells();
    float cellError(int x, int y, int z) const noexcept;
    float listTriangles(MadeBrick& made);
    void prune(const glm::dvec3& centre);
    void pack(MadeBrick& made) const;
    void packResiduals(MadeBrick& made, const std::array<float, CellGrid::samples>& residuals, float half) const;

    const MeshDistance& part_;
    PartAsker asker_;
    glm::dvec3 origin_;
    double voxel_;
    glm::dvec3 corner_{0.0};
    SampleGrid five_{5}, nine_{9};
    float sampleError_ = 0.0F; ///< of samples that were not asked for, voxels
    std::array<std::uint64_t, 8> mask_{};
    std::vector<std::uint32_t> near_;
};

} // namespace burin
