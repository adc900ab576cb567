// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/part_field/part_field.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

namespace burin {

/// A grid of (cells + 1) samples along each axis, x running fastest: the contents of a brick of any size.
struct CellGrid {
    static constexpr int cells = 8;
    static constexpr int along = cells + 1;
    static constexpr int samples = along * along * along;
    static constexpr int cellCount = cells * cells * cells;
    static std::size_t sampleAt(int x, int y, int z) noexcept {
        return static_cast<std::size_t>(x + along * (y + along * z));
    }
    static glm::ivec3 cellOf(int sample) noexcept {
        return {sample % along, sample / along % along, sample / (along * along)};
    }
    static std::size_t cellAt(int x, int y, int z) noexcept {
        return static_cast<std::size_t>(x + cells * (y + cells * z));
    }
};

/// A fine brick: 8 x 8 x 8 cells of a voxel. A sample is the value of a plane at its position plus a residual. Where
/// the part is smooth the residual is so small that 8 bits are more than enough.
struct FineBrick {
    float base = 0.0F;            ///< mm, the plane at sample (0, 0, 0)
    std::array<float, 3> slope{}; ///< mm per voxel
    float quantum = 0.0F;         ///< mm, one unit of a residual
    std::uint32_t samples = 0;    ///< index of the residuals, counted in bricks of the same kind
    std::uint32_t exact = none;   ///< index of its exact cells
    std::uint32_t wide = 0;       ///< 1: residuals of 16 bits

    static constexpr std::uint32_t none = 0xFFFFFFFFU;
};

/// Cells of a fine brick in which a trilinear value is not accurate enough: an edge or a ridge of equal distances
/// passes through. They list the triangles that are nearest to some point of them.
struct ExactCells {
    std::array<std::uint64_t, 8> mask{};   ///< one word per layer, bit x + 8 y
    std::array<std::uint16_t, 8> before{}; ///< cells in the layers below
    std::uint32_t first = 0;               ///< of the brick's cells in `cellLists`

    bool contains(int x, int y, int z) const noexcept {
        return ((mask[static_cast<std::size_t>(z)] >> (x + 8 * y)) & 1U) != 0;
    }
    std::size_t rank(int x, int y, int z) const noexcept {
        const std::uint64_t lower = (std::uint64_t{1} << (x + 8 * y)) - 1;
        const auto layer = static_cast<std::size_t>(z);
        return before[layer] + static_cast<std::size_t>(std::popcount(mask[layer] & lower));
    }
};

/// 8 x 8 x 8 bricks: the distances at their corners, which of them are fine, and the bounds for each.
struct FieldBlock {
    static constexpr std::int32_t coarse = -1;
    std::array<float, CellGrid::samples> corners;       ///< mm
    std::array<std::int32_t, CellGrid::cellCount> fine; ///< number of the fine brick, or `coarse`
    std::array<float, CellGrid::cellCount> bound;       ///< largest error in the brick, mm
    std::array<float, CellGrid::cellCount> least;       ///< mm, lower bound of the distance to the surface
};

/// Three layers of grids: blocks of 64 voxels with samples at their corners; blocks within the reach divided into
/// bricks of 8 voxels; bricks at the surface divided into cells.
class PartFieldLayers {
public:
    static constexpr int brickVoxels = CellGrid::cells;
    static constexpr int blockVoxels = brickVoxels * CellGrid::cells;
    static constexpr int narrowStride = 736; ///< bytes a brick of 8-bit residuals
    static constexpr std::int32_t coarse = -1;

    /// A position in the box of the layers.
    struct Place {
        glm::ivec3 voxel{0};   ///< counted from the origin
        glm::vec3 share{0.0F}; ///< within the voxel, 0 … 1
        double outside = 0.0;  ///< mm from the box: the position is then its nearest point
    };
    Place place(const glm::dvec3& point) const noexcept {
        const glm::dvec3 wanted = (point - origin) * perVoxel_;
        if (wanted.x >= 0.0 && wanted.y >= 0.0 && wanted.z >= 0.0 && wanted.x < voxelCount_.x &&
            wanted.y < voxelCount_.y && wanted.z < voxelCount_.z) {
            const glm::ivec3 voxel(wanted);
            return {voxel, glm::vec3(wanted - glm::dvec3(voxel)), 0.0};
        }
        return placeOutside(wanted);
    }
    /// Called once the blocks are known.
    void setScale() noexcept;

    PartDistance sample(const glm::dvec3& point) const noexcept;
    void sample(std::span<const glm::dvec3> points, std::span<PartDistance> answers) const noexcept;
    double bound(const glm::dvec3& point) const noexcept;
    double leastIn(const Box& box) const noexcept;

    std::size_t fineBytes() const noexcept;
    std::size_t memoryBytes() const noexcept;

    /// The box covered by the blocks.
    Box box() const noexcept { return {origin, origin + glm::dvec3(blocks) * (blockVoxels * request.voxel)}; }
    std::size_t blockAt(const glm::ivec3& b) const noexcept { return at(b, blocks); }
    /// Index of a block in `divided`; `coarse` where it is not divided or there is none.
    std::int32_t blockNumberAt(const glm::ivec3& b) const noexcept {
        if (glm::any(glm::lessThan(b, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(b, blocks))) return coarse;
        return blockNumber[blockAt(b)];
    }
    std::size_t topAt(const glm::ivec3& c) const noexcept { return at(c, blocks + 1); }

    std::shared_ptr<const MeshDistance> part;
    PartFieldRequest request;
    Box meshBounds;      ///< mm
    double margin = 0.0; ///< mm from the mesh's box to that of the layers
    glm::dvec3 origin{0.0};
    glm::ivec3 blocks{1};
    std::size_t bandVoxels = 0;

    std::vector<std::int32_t> blockNumber; ///< per block: its index in `divided`, or `coarse`
    std::vector<float> topCorners;         ///< mm
    std::vector<float> topBound;           ///< per block, mm
    std::vector<float> topLeast;           ///< per block, mm: also for divided blocks
    std::vector<FieldBlock> divided;
    std::vector<FineBrick> bricks;
    std::vector<std::int8_t> narrow;
    std::vector<std::int16_t> wide;
    std::vector<ExactCells> exactCells;
    std::vector<std::uint32_t> cellLists; ///< per exact cell: where its list begins
    std::vector<std::uint32_t> lists;     ///< a count, followed by that many triangles

private:
    class Batch;
    static std::size_t at(const glm::ivec3& i, const glm::ivec3& n) noexcept {
        return static_cast<std::size_t>(i.x) +
               static_cast<std::size_t>(n.x) *
                   (static_cast<std::size_t>(i.y) + static_cast<std::size_t>(n.y) * static_cast<std::size_t>(i.z));
    }
    glm::dvec3 voxelCount_{0.0}; ///< along each axis
    double perVoxel_ = 0.0;      ///< 1/mm

    bool isExact(const FineBrick& brick, const glm::ivec3& voxel) const noexcept {
        return brick.exact != FineBrick::none &&
               exactCells[brick.exact].contains(voxel.x & 7, voxel.y & 7, voxel.z & 7);
    }
    Place placeOutside(const glm::dvec3& wanted) const noexcept;
    PartDistance sampleInside(const glm::dvec3& point, const Place& place) const noexcept;
    /// The fine brick that contains a voxel; null where the layers are coarse.
    const FineBrick* fineBrickAt(const glm::ivec3& voxel) const noexcept {
        const std::int32_t block = blockNumber[blockAt(voxel >> 6)];
        if (block == coarse) return nullptr;
        const glm::ivec3 b = (voxel >> 3) & 7;
        const std::int32_t number = divided[static_cast<std::size_t>(block)].fine[CellGrid::cellAt(b.x, b.y, b.z)];
        return number == coarse ? nullptr : &bricks[static_cast<std::size_t>(number)];
    }
    PartDistance sampleFine(const FineBrick& brick, const Place& place) const noexcept;
    PartDistance sampleCoarse(const Place& place) const noexcept;
    PartDistance sampleOutside(const glm::dvec3& point, const Place& place) const noexcept;
    PartDistance sampleExact(const ExactCells& exact, const glm::ivec3& cell, const glm::dvec3& point) const noexcept;
};

} // namespace burin
