// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/part_field/part_field_layers.h"

#include "core/field/cube.h"
#include "core/geometry/four_floats.h"

#include <algorithm>
#include <limits>

namespace burin {

namespace {

constexpr int row = CellGrid::along, layer = CellGrid::along * CellGrid::along;

/// Corners of a cell: the four on its lower face, x running fastest, and the four above them. Kept in registers: a
/// vector that is assembled in memory piece by piece is slow to load as one.
struct Corners {
    FourFloats low, high;
};

Corners cornersAt(const float* first) noexcept {
    return {FourFloats{first[0], first[1], first[row], first[row + 1]},
            FourFloats{first[layer], first[layer + 1], first[layer + row], first[layer + row + 1]}};
}

template <class Number>
Corners cornersAt(const Number* first) noexcept {
    const FourInts low{first[0], first[1], first[row], first[row + 1]};
    const FourInts high{first[layer], first[layer + 1], first[layer + row], first[layer + row + 1]};
    return {__builtin_convertvector(low, FourFloats), __builtin_convertvector(high, FourFloats)};
}

/// Value and gradient, per edge of the cell, interpolated between eight corners.
PartDistance between(const Corners& corners, const glm::vec3& t) noexcept {
    const FourFloats rise = corners.high - corners.low, middle = corners.low + t.z * rise;
    const float x0 = middle[1] - middle[0], x1 = middle[3] - middle[2];
    const float y0 = middle[0] + t.x * x0, y1 = middle[2] + t.x * x1;
    const float z0 = rise[0] + t.x * (rise[1] - rise[0]), z1 = rise[2] + t.x * (rise[3] - rise[2]);
    return {y0 + t.y * (y1 - y0), {x0 + t.y * (x1 - x0), y1 - y0, z0 + t.y * (z1 - z0)}};
}

/// Size of a vector's contents in bytes.
template <class Item>
std::size_t bytes(const std::vector<Item>& items) noexcept {
    return items.capacity() * sizeof(Item);
}

} // namespace

void PartFieldLayers::setScale() noexcept {
    voxelCount_ = glm::dvec3(blocks * blockVoxels);
    perVoxel_ = 1.0 / request.voxel;
}

PartFieldLayers::Place PartFieldLayers::placeOutside(const glm::dvec3& wanted) const noexcept {
    Place place;
    glm::dvec3 kept;
    for (int axis = 0; axis < 3; ++axis) { // not a number: the low side
        kept[axis] = wanted[axis] > 0.0 ? std::min(wanted[axis], voxelCount_[axis]) : 0.0;
        place.voxel[axis] = std::min(static_cast<int>(kept[axis]), blocks[axis] * blockVoxels - 1);
    }
    place.share = glm::vec3(kept - glm::dvec3(place.voxel));
    place.outside = glm::length(wanted - kept) * request.voxel;
    return place;
}

PartDistance PartFieldLayers::sampleFine(const FineBrick& brick, const Place& place) const noexcept {
    const glm::ivec3 cell = place.voxel & 7;
    const std::size_t first = CellGrid::sampleAt(cell.x, cell.y, cell.z);
    const Corners corners = brick.wide != 0
                                ? cornersAt(wide.data() + std::size_t{brick.samples} * CellGrid::samples + first)
                                : cornersAt(narrow.data() + std::size_t{brick.samples} * narrowStride + first);
    const PartDistance rest = between(corners, place.share);
    const glm::vec3 along = glm::vec3(cell) + place.share, slope{brick.slope[0], brick.slope[1], brick.slope[2]};
    const auto perVoxel = static_cast<float>(perVoxel_);
    return {brick.base + glm::dot(slope, along) + brick.quantum * rest.distance,
            (slope + brick.quantum * rest.gradient) * perVoxel};
}

PartDistance PartFieldLayers::sampleExact(const ExactCells& exact, const glm::ivec3& cell,
                                          const glm::dvec3& point) const noexcept {
    const std::uint32_t list = cellLists[exact.first + exact.rank(cell.x, cell.y, cell.z)];
    const ClosestPoint closest = part->closestOf(std::span(lists).subspan(list + 1, lists[list]), point);
    const glm::dvec3 way = point - closest.point;
    // On a sheet without thickness the normals of both sides add up to zero.
    const glm::dvec3 out = closest.distance > 1e-9              ? way / closest.signedDistance
                           : closest.outward != glm::dvec3(0.0) ? glm::normalize(closest.outward)
                                                                : glm::dvec3(0.0);
    return {static_cast<float>(closest.signedDistance), glm::vec3(out)};
}

PartDistance PartFieldLayers::sampleCoarse(const Place& place) const noexcept {
    const glm::ivec3 block = place.voxel >> 6;
    const std::int32_t number = blockNumber[blockAt(block)];
    PartDistance answer;
    double edge = request.voxel;
    if (number != coarse) {
        const glm::ivec3 b = (place.voxel >> 3) & 7;
        const glm::vec3 share = (glm::vec3(place.voxel & 7) + place.share) / static_cast<float>(brickVoxels);
        const float* first =
            divided[static_cast<std::size_t>(number)].corners.data() + CellGrid::sampleAt(b.x, b.y, b.z);
        answer = between(cornersAt(first), share);
        edge *= brickVoxels;
    } else {
        const glm::vec3 share = (glm::vec3(place.voxel & 63) + place.share) / static_cast<float>(blockVoxels);
        const float* first = topCorners.data() + topAt(block);
        const auto n = glm::i64vec3(blocks) + std::int64_t{1};
        const float *next = first + n.x, *above = first + n.x * n.y, *last = above + n.x;
        answer = between(
            {FourFloats{first[0], first[1], next[0], next[1]}, FourFloats{above[0], above[1], last[0], last[1]}},
            share);
        edge *= blockVoxels;
    }
    answer.gradient /= static_cast<float>(edge);
    return answer;
}

/// As at the nearest point of the layers' box; but the part lies in its own box, so a distance of at least that to its
/// box is certain.
PartDistance PartFieldLayers::sampleOutside(const glm::dvec3& point, const Place& place) const noexcept {
    const glm::dvec3 nearest = origin + (glm::dvec3(place.voxel) + glm::dvec3(place.share)) * request.voxel;
    PartDistance answer = sampleInside(nearest, place);
    if (meshBounds.empty()) return answer;
    const glm::dvec3 away = glm::max(glm::max(meshBounds.low - point, point - meshBounds.high), glm::dvec3(0.0));
    answer.distance = std::max(answer.distance, static_cast<float>(glm::length(away)));
    return answer;
}

PartDistance PartFieldLayers::sampleInside(const glm::dvec3& point, const Place& place) const noexcept {
    const FineBrick* brick = fineBrickAt(place.voxel);
    if (brick == nullptr) return sampleCoarse(place);
    return isExact(*brick, place.voxel) ? sampleExact(exactCells[brick->exact], place.voxel & 7, point)
                                        : sampleFine(*brick, place);
}

PartDistance PartFieldLayers::sample(const glm::dvec3& point) const noexcept {
    const Place where = place(point);
    return where.outside > 0.0 ? sampleOutside(point, where) : sampleInside(point, where);
}

double PartFieldLayers::bound(const glm::dvec3& point) const noexcept {
    const Place where = place(point);
    const std::size_t block = blockAt(where.voxel >> 6);
    if (blockNumber[block] == coarse) return static_cast<double>(topBound[block]) + where.outside;
    const glm::ivec3 b = (where.voxel >> 3) & 7;
    const FieldBlock& in = divided[static_cast<std::size_t>(blockNumber[block])];
    return static_cast<double>(in.bound[CellGrid::cellAt(b.x, b.y, b.z)]) + where.outside;
}

double PartFieldLayers::leastIn(const Box& box) const noexcept {
    if (box.empty() || meshBounds.empty()) return meshBounds.empty() ? static_cast<double>(topLeast.front()) : 0.0;
    // No point is nearer than the box's centre minus the distance from there.
    const glm::dvec3 middle = box.centre();
    double least =
        std::abs(static_cast<double>(sample(middle).distance)) - bound(middle) - 0.5 * glm::length(box.size());
    const glm::dvec3 apart = glm::max(glm::max(meshBounds.low - box.high, box.low - meshBounds.high), glm::dvec3(0.0));
    least = std::max(least, glm::length(apart));

    const Place low = place(box.low), high = place(box.high);
    double found = std::numeric_limits<double>::infinity();
    if (low.outside > 0.0 || high.outside > 0.0) found = margin;
    const glm::ivec3 firstBlock = low.voxel >> 6, lastBlock = high.voxel >> 6;
    for (int z = firstBlock.z; z <= lastBlock.z; ++z)
        for (int y = firstBlock.y; y <= lastBlock.y; ++y)
            for (int x = firstBlock.x; x <= lastBlock.x; ++x) {
                const std::size_t block = blockAt({x, y, z});
                const auto whole = static_cast<double>(topLeast[block]);
                if (whole >= found) continue;
                if (blockNumber[block] == coarse) {
                    found = whole;
                    continue;
                }
                const FieldBlock& in = divided[static_cast<std::size_t>(blockNumber[block])];
                const glm::ivec3 corner = glm::ivec3(x, y, z) * CellGrid::cells;
                const glm::ivec3 from = glm::clamp((low.voxel >> 3) - corner, 0, 7);
                const glm::ivec3 to = glm::clamp((high.voxel >> 3) - corner, 0, 7);
                for (int k = from.z; k <= to.z; ++k)
                    for (int j = from.y; j <= to.y; ++j)
                        for (int i = from.x; i <= to.x; ++i)
                            found = std::min(found, static_cast<double>(in.least[CellGrid::cellAt(i, j, k)]));
            }
    return std::max({least, found, 0.0});
}

std::size_t PartFieldLayers::fineBytes() const noexcept {
    return bytes(bricks) + bytes(narrow) + bytes(wide) + bytes(exactCells) + bytes(cellLists) + bytes(lists);
}

std::size_t PartFieldLayers::memoryBytes() const noexcept {
    return sizeof(PartFieldLayers) + fineBytes() + bytes(blockNumber) + bytes(topCorners) + bytes(topBound) +
           bytes(topLeast) + bytes(divided);
}

} // namespace burin
