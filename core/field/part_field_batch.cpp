// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/vectorised.h"
#include "core/field/part_field_layers.h"

#include <algorithm>

namespace burin {

namespace {

/// Points side by side, in groups of eight: gathered one by one, computed eight at a time.
struct Chunk {
    static constexpr std::size_t groups = 8;
    static constexpr std::size_t points = groups * lanes;

    struct Group {
        std::array<EightIntegers, 8> corners; ///< residuals at the corners of the cell, x running fastest
        std::array<EightFloats, 3> share;     ///< of the cell
        std::array<EightFloats, 3> along;     ///< voxels from the brick's lowest corner
        std::array<EightFloats, 3> slope;
        EightFloats base, quantum;
    };
    std::array<Group, groups> group{};
};

template <class Number>
BURIN_INLINE void gatherCorners(const Number* first, Chunk::Group& group, int lane) noexcept {
    constexpr std::array<int, 8> steps{0, 1, 9, 10, 81, 82, 90, 91};
    for (std::size_t i = 0; i < 8; ++i) group.corners[i][lane] = first[steps[i]];
}

BURIN_INLINE Floats mixed(Floats a, Floats b, Floats share) noexcept {
    return a + share * (b - a);
}

BURIN_INLINE void computeGroup(const Chunk::Group& group, Floats perVoxel, PartDistance* answers,
                               std::size_t count) noexcept {
    std::array<Floats, 8> c;
    for (std::size_t i = 0; i < 8; ++i) c[i] = floatsOf(load(group.corners[i]));
    const Floats x = load(group.share[0]), y = load(group.share[1]), z = load(group.share[2]);
    const Floats low0 = mixed(c[0], c[4], z), low1 = mixed(c[1], c[5], z), high0 = mixed(c[2], c[6], z),
                 high1 = mixed(c[3], c[7], z);
    const Floats alongX = mixed(low1 - low0, high1 - high0, y);
    const Floats y0 = mixed(low0, low1, x), y1 = mixed(high0, high1, x);
    const Floats alongZ = mixed(mixed(c[4] - c[0], c[5] - c[1], x), mixed(c[6] - c[2], c[7] - c[3], x), y);
    const Floats quantum = load(group.quantum);
    const Floats slopeX = load(group.slope[0]), slopeY = load(group.slope[1]), slopeZ = load(group.slope[2]);
    EightFloats distance, gradientX, gradientY, gradientZ;
    const Floats plane = slopeX * load(group.along[0]) + slopeY * load(group.along[1]) + slopeZ * load(group.along[2]);
    store(load(group.base) + plane + quantum * mixed(y0, y1, y), distance);
    store((slopeX + quantum * alongX) * perVoxel, gradientX);
    store((slopeY + quantum * (y1 - y0)) * perVoxel, gradientY);
    store((slopeZ + quantum * alongZ) * perVoxel, gradientZ);
    for (std::size_t i = 0; i < count; ++i) {
        const int lane = static_cast<int>(i);
        answers[i] = {distance[lane], {gradientX[lane], gradientY[lane], gradientZ[lane]}};
    }
}

BURIN_VECTORISED void compute(const Chunk& chunk, float perVoxel, PartDistance* answers, std::size_t count) noexcept {
    const Floats scale = floats(perVoxel);
    for (std::size_t first = 0; first < count; first += lanes)
        computeGroup(chunk.group[first / lanes], scale, answers + first, std::min<std::size_t>(lanes, count - first));
}

} // namespace

void PartFieldLayers::sample(std::span<const glm::dvec3> points, std::span<PartDistance> answers) const noexcept {
    Chunk chunk;
    std::array<std::uint32_t, Chunk::points> others; // what is not in a fine brick's trilinear cell
    for (std::size_t first = 0; first < points.size(); first += Chunk::points) {
        const std::size_t count = std::min(Chunk::points, points.size() - first);
        std::size_t otherCount = 0;
        for (std::size_t i = 0; i < count; ++i) {
            Chunk::Group& group = chunk.group[i / lanes];
            const int lane = static_cast<int>(i % lanes);
            const Place where = place(points[first + i]);
            const FineBrick* const brick = where.outside > 0.0 ? nullptr : fineBrickAt(where.voxel);
            if (brick == nullptr || isExact(*brick, where.voxel)) {
                others[otherCount++] = static_cast<std::uint32_t>(i);
                continue; // the lane keeps what it held
            }
            const glm::ivec3 cell = where.voxel & 7;
            const std::size_t sample = CellGrid::sampleAt(cell.x, cell.y, cell.z);
            if (brick->wide != 0)
                gatherCorners(wide.data() + std::size_t{brick->samples} * CellGrid::samples + sample, group, lane);
            else
                gatherCorners(narrow.data() + std::size_t{brick->samples} * narrowStride + sample, group, lane);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const float share = where.share[static_cast<int>(axis)];
                group.share[axis][lane] = share;
                group.along[axis][lane] = static_cast<float>(cell[static_cast<int>(axis)]) + share;
                group.slope[axis][lane] = brick->slope[axis];
            }
            group.base[lane] = brick->base;
            group.quantum[lane] = brick->quantum;
        }
        compute(chunk, static_cast<float>(perVoxel_), answers.data() + first, count);
        for (std::size_t i = 0; i < otherCount; ++i) answers[first + others[i]] = sample(points[first + others[i]]);
    }
}

} // namespace burin
