// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/field/cube.h"
#include "core/field/sample_grid.h"
#include "tests/part_field/part_asker.h"
#include "tests/part_field/part_field_layers.h"

#include <cstdint>
#include <vector>

namespace burin {

/// Samples at the corners of all bricks of the divided blocks: every second corner is sampled from the mesh; those
/// between are sampled where the surface is within reach and interpolated elsewhere.
class BlockCorners {
public:
    static constexpr int cubes = 64; ///< of 2 x 2 x 2 bricks, per block
    static constexpr std::size_t bytesPerBlock() noexcept {
        return (perBlock + evensPerBlock + CellGrid::samples) * sizeof(DistanceSample) + sizeof(std::uint64_t);
    }

    /// @param places of the divided blocks, in their order
    BlockCorners(const MeshDistance& part, PartFieldLayers& layers, const std::vector<glm::ivec3>& places);

    /// Also fills the layers' corners. Parallel; reports progress between the two fractions.
    void sample(Progress& progress, double from, double to);

    /// Whether the cube of 2 x 2 x 2 bricks that a brick belongs to may be within reach: its corners were then sampled.
    bool isNear(std::size_t block, const glm::ivec3& brick) const noexcept;
    std::array<DistanceSample, 8> brickCorners(std::size_t block, const glm::ivec3& brick) const noexcept;
    std::array<DistanceSample, 8> cubeCorners(std::size_t block, const glm::ivec3& cube) const noexcept;
    static glm::ivec3 cubeAt(int cube) noexcept { return {cube & 3, (cube >> 2) & 3, cube >> 4}; }

private:
    static constexpr std::size_t perBlock = CellGrid::cellCount; ///< corners that a block owns
    static constexpr std::size_t evensPerBlock = 125;

    static std::size_t evenAt(const glm::ivec3& e) noexcept {
        return static_cast<std::size_t>(e.x + 5 * (e.y + 5 * e.z));
    }
    PartAsker asker() const { return {part_, layers_.origin, layers_.request.voxel}; }
    void sampleEven(std::size_t block);
    void gatherEven(std::size_t block, PartAsker& ask);
    void sampleOwned(std::size_t block);
    void gatherCorners(std::size_t block);
    DistanceSample cornerOfBlock(std::size_t block, const glm::ivec3& corner, PartAsker& ask) const;

    const MeshDistance& part_;
    PartFieldLayers& layers_;
    const std::vector<glm::ivec3>& places_;
    std::vector<DistanceSample> owned_;   ///< per block
    std::vector<DistanceSample> evens_;   ///< per block, every second corner, including upper faces
    std::vector<std::uint64_t> near_;     ///< per block, a bit per cube: whether it is within reach
    std::vector<DistanceSample> corners_; ///< per block, all corners, including those on its upper faces
};

} // namespace burin
