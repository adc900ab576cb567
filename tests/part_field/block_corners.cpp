// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/part_field/block_corners.h"

#include "core/field/spread.h"
#include "tests/part_field/coarse_bound.h"

namespace burin {

namespace {

constexpr int brickVoxels = PartFieldLayers::brickVoxels;
constexpr std::int32_t coarse = PartFieldLayers::coarse;

} // namespace

BlockCorners::BlockCorners(const MeshDistance& part, PartFieldLayers& layers, const std::vector<glm::ivec3>& places)
    : part_(part)
    , layers_(layers)
    , places_(places)
    , owned_(places.size() * perBlock)
    , evens_(places.size() * evensPerBlock)
    , near_(places.size()) {}

/// Every second corner is sampled; those between only where the surface is within reach.
void BlockCorners::sample(Progress& progress, double from, double to) {
    const auto at = [&](double share) { return from + share * (to - from); };
    const auto reach = static_cast<float>(layers_.request.reach / layers_.request.voxel);
    spread(places_.size(), from, at(0.1), progress, [&](std::size_t block) { sampleEven(block); });
    spread(places_.size(), at(0.1), at(0.25), progress, [&](std::size_t block) {
        PartAsker ask = asker();
        gatherEven(block, ask);
        near_[block] = 0;
        for (int cube = 0; cube < cubes; ++cube)
            if (mayBeWithin(cubeCorners(block, cubeAt(cube)), 2.0F * brickVoxels, reach))
                near_[block] |= std::uint64_t{1} << cube;
    });
    spread(places_.size(), at(0.25), at(0.9), progress, [&](std::size_t block) { sampleOwned(block); });
    corners_.resize(places_.size() * CellGrid::samples);
    spread(places_.size(), at(0.9), to, progress, [&](std::size_t block) { gatherCorners(block); });
    owned_ = {};
}

/// Each block samples those that are not on its upper faces.
void BlockCorners::sampleEven(std::size_t block) {
    PartAsker ask = asker();
    for (int z = 0; z < 8; z += 2)
        for (int row = 0; row < 8; row += 2)
            for (int column = 0; column < 8; column += 2) { // back and forth: each near the previous one
                const int y = z % 4 == 0 ? row : 6 - row, x = row % 4 == 0 ? column : 6 - column;
                owned_[block * perBlock + CellGrid::cellAt(x, y, z)] =
                    ask.ask(brickVoxels * (8 * places_[block] + glm::ivec3(x, y, z)));
            }
}

void BlockCorners::gatherEven(std::size_t block, PartAsker& ask) {
    for (int z = 0; z < 5; ++z)
        for (int y = 0; y < 5; ++y)
            for (int x = 0; x < 5; ++x) {
                const glm::ivec3 local = 2 * glm::ivec3(x, y, z), step = local / 8, in = local - 8 * step;
                const std::int32_t number = layers_.blockNumberAt(places_[block] + step);
                evens_[block * evensPerBlock + evenAt({x, y, z})] =
                    number == coarse
                        ? ask.ask(brickVoxels * (8 * places_[block] + local))
                        : owned_[static_cast<std::size_t>(number) * perBlock + CellGrid::cellAt(in.x, in.y, in.z)];
            }
}

void BlockCorners::sampleOwned(std::size_t block) {
    PartAsker ask = asker();
    for (int z = 0; z < 8; ++z)
        for (int row = 0; row < 8; ++row)
            for (int column = 0; column < 8; ++column) {
                const int y = z % 2 == 0 ? row : 7 - row, x = row % 2 == 0 ? column : 7 - column;
                if (x % 2 != 0 || y % 2 != 0 || z % 2 != 0)
                    owned_[block * perBlock + CellGrid::cellAt(x, y, z)] = cornerOfBlock(block, {x, y, z}, ask);
            }
}

void BlockCorners::gatherCorners(std::size_t block) {
    PartAsker ask = asker();
    for (int z = 0; z < 9; ++z)
        for (int y = 0; y < 9; ++y)
            for (int x = 0; x < 9; ++x) {
                const glm::ivec3 local{x, y, z}, step = local / 8, in = local - 8 * step;
                const std::int32_t number = layers_.blockNumberAt(places_[block] + step);
                const std::size_t at = CellGrid::sampleAt(x, y, z);
                DistanceSample& sample = corners_[block * CellGrid::samples + at];
                sample = number == coarse
                             ? cornerOfBlock(block, local, ask)
                             : owned_[static_cast<std::size_t>(number) * perBlock + CellGrid::cellAt(in.x, in.y, in.z)];
                layers_.divided[block].corners[at] =
                    static_cast<float>(static_cast<double>(sample.distance) * layers_.request.voxel);
            }
}

/// Sampled if a cube that it belongs to is within reach, otherwise interpolated between the even corners.
DistanceSample BlockCorners::cornerOfBlock(std::size_t block, const glm::ivec3& corner, PartAsker& ask) const {
    for (int i = 0; i < 8; ++i) {
        const glm::ivec3 cube = (8 * places_[block] + corner - cornerOf(i)) >> 1; // counted from the origin
        const std::int32_t number = layers_.blockNumberAt(cube >> 2);
        if (number == coarse) continue;
        const glm::ivec3 in = cube & 3;
        if (((near_[static_cast<std::size_t>(number)] >> (in.x + 4 * in.y + 16 * in.z)) & 1U) != 0)
            return ask.ask(brickVoxels * (8 * places_[block] + corner));
    }
    const glm::ivec3 cube = glm::min(corner / 2, 3);
    const glm::vec3 share = 0.5F * glm::vec3(corner - 2 * cube);
    const std::array<DistanceSample, 8> corners = cubeCorners(block, cube);
    DistanceSample sum;
    for (int i = 0; i < 8; ++i) {
        const glm::vec3 weight = glm::mix(1.0F - share, share, glm::vec3(cornerOf(i)));
        const float part = weight.x * weight.y * weight.z;
        sum.distance += part * corners[static_cast<std::size_t>(i)].distance;
        sum.gradient += part * corners[static_cast<std::size_t>(i)].gradient;
    }
    return sum;
}

std::array<DistanceSample, 8> BlockCorners::cubeCorners(std::size_t block, const glm::ivec3& cube) const noexcept {
    std::array<DistanceSample, 8> corners;
    for (int i = 0; i < 8; ++i)
        corners[static_cast<std::size_t>(i)] = evens_[block * evensPerBlock + evenAt(cube + cornerOf(i))];
    return corners;
}

bool BlockCorners::isNear(std::size_t block, const glm::ivec3& brick) const noexcept {
    const glm::ivec3 cube = brick / 2;
    return ((near_[block] >> (cube.x + 4 * cube.y + 16 * cube.z)) & 1U) != 0;
}

std::array<DistanceSample, 8> BlockCorners::brickCorners(std::size_t block, const glm::ivec3& brick) const noexcept {
    std::array<DistanceSample, 8> corners;
    for (int i = 0; i < 8; ++i) {
        const glm::ivec3 at = brick + cornerOf(i);
        corners[static_cast<std::size_t>(i)] =
            corners_[block * CellGrid::samples + CellGrid::sampleAt(at.x, at.y, at.z)];
    }
    return corners;
}

} // namespace burin
