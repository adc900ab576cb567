// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/field/part_field_layers.h"

#include <algorithm>
#include <limits>

namespace burin {

namespace {

constexpr int row = CellGrid::along, layer = CellGrid::along * CellGrid::along;
constexpr double halfDiagonal = 0.8660254037844387; // of a cube of edge 1

using Corners = std::array<float, 8>; // of a cell, x running fastest

template <class Number>
Corners cornersAt(const Number* first) noexcept {
    const auto number = [first](int i) noexcept { return static_cast<float>(first[i]); };
    return {number(0),     number(1),         number(row),         number(row + 1),
            number(layer), number(layer + 1), number(layer + row), number(layer + row + 1)};
}

/// Value and gradient, per edge of the cell, between eight corners.
PartDistance between(const Corners& c, const glm::vec3& t) noexcept {
    const float d00 = c[1] - c[0], d10 = c[3] - c[2], d01 = c[5] - c[4], d11 = c[7] - c[6];
    const float x00 = c[0] + t.x * d00, x10 = c[2] + t.x * d10, x01 = c[4] + t.x * d01, x11 = c[6] + t.x * d11;
    const float y0 = x10 - x00, y1 = x11 - x01;
    const float z0 = x00 + t.y * y0, z1 = x01 + t.y * y1;
    const float e0 = d00 + t.y * (d10 - d00), e1 = d01 + t.y * (d11 - d01);
    return {z0 + t.z * (z1 - z0), {e0 + t.z * (e1 - e0), y0 + t.z * (y1 - y0), z1 - z0}};
}

/// Bytes that a vector holds.
template <class Item>
std::size_t bytes(const std::vector<Item>& items) noexcept {
    return items.capacity() * sizeof(Item);
}

} // namespace

PartFieldLayers::Place PartFieldLayers::place(const glm::dvec3& point) const noexcept {
    Place place;
    double outside = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        const int voxels = blocks[axis] * blockVoxels;
        const double wanted = (point[axis] - origin[axis]) / request.voxel;
        const double kept = wanted > 0.0 ? std::min(wanted, static_cast<double>(voxels)) : 0.0; // not a number: 0
        place.voxel[axis] = std::min(static_cast<int>(kept), voxels - 1);
        place.share[axis] = static_cast<float>(kept - place.voxel[axis]);
        outside += (wanted - kept) * (wanted - kept);
    }
    place.outside = outside > 0.0 ? std::sqrt(outside) * request.voxel : 0.0;
    return place;
}

const FineBrick* PartFieldLayers::fineBrickAt(const glm::ivec3& voxel) const noexcept {
    const std::int32_t block = blockNumber[blockAt(voxel >> 6)];
    if (block == coarse) return nullptr;
    const glm::ivec3 b = (voxel >> 3) & 7;
    const std::int32_t number = divided[static_cast<std::size_t>(block)].fine[CellGrid::cellAt(b.x, b.y, b.z)];
    return number == coarse ? nullptr : &bricks[static_cast<std::size_t>(number)];
}

PartDistance PartFieldLayers::sampleFine(const FineBrick& brick, const Place& place) const noexcept {
    const glm::ivec3 cell = place.voxel & 7;
    const std::size_t first = CellGrid::sampleAt(cell.x, cell.y, cell.z);
    const Corners corners = brick.wide != 0
                                ? cornersAt(wide.data() + std::size_t{brick.samples} * CellGrid::samples + first)
                                : cornersAt(narrow.data() + std::size_t{brick.samples} * narrowStride + first);
    const PartDistance rest = between(corners, place.share);
    const glm::vec3 along = glm::vec3(cell) + place.share, slope{brick.slope[0], brick.slope[1], brick.slope[2]};
    const auto perVoxel = static_cast<float>(1.0 / request.voxel);
    return {brick.base + glm::dot(slope, along) + brick.quantum * rest.distance,
            (slope + brick.quantum * rest.gradient) * perVoxel};
}

PartDistance PartFieldLayers::sampleExact(const ExactCells& exact, const glm::ivec3& cell,
                                          const glm::dvec3& point) const noexcept {
    const std::uint32_t list = cellLists[exact.first + exact.rank(cell.x, cell.y, cell.z)];
    const ClosestPoint closest = part->closestOf(std::span(lists).subspan(list + 1, lists[list]), point);
    const glm::dvec3 way = point - closest.point;
    const glm::dvec3 out = closest.distance > 1e-9 ? way / closest.signedDistance : glm::normalize(closest.outward);
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
        Corners corners;
        for (int i = 0; i < 8; ++i)
            corners[static_cast<std::size_t>(i)] =
                topCorners[topAt(block + glm::ivec3(i & 1, (i >> 1) & 1, (i >> 2) & 1))];
        answer = between(corners, share);
        edge *= blockVoxels;
    }
    answer.gradient /= static_cast<float>(edge);
    return answer;
}

/// As the nearest point of the layers' box; but the part lies in its own box, and what lies beyond is no nearer.
PartDistance PartFieldLayers::sampleOutside(const glm::dvec3& point) const noexcept {
    const Box covered = box();
    glm::dvec3 kept; // what is not a number: the low side
    for (int axis = 0; axis < 3; ++axis)
        kept[axis] = point[axis] > covered.low[axis] ? std::min(point[axis], covered.high[axis]) : covered.low[axis];
    PartDistance answer = sample(kept);
    if (meshBounds.empty()) return answer;
    const glm::dvec3 away = glm::max(glm::max(meshBounds.low - point, point - meshBounds.high), glm::dvec3(0.0));
    answer.distance = std::max(answer.distance, static_cast<float>(glm::length(away)));
    return answer;
}

PartDistance PartFieldLayers::sample(const glm::dvec3& point) const noexcept {
    const Place where = place(point);
    if (where.outside > 0.0) return sampleOutside(point);
    const FineBrick* brick = fineBrickAt(where.voxel);
    if (brick == nullptr) return sampleCoarse(where);
    if (brick->exact != FineBrick::none) {
        const glm::ivec3 cell = where.voxel & 7;
        const ExactCells& exact = exactCells[brick->exact];
        if (exact.contains(cell.x, cell.y, cell.z)) return sampleExact(exact, cell, point);
    }
    return sampleFine(*brick, where);
}

void PartFieldLayers::sample(std::span<const glm::dvec3> points, std::span<PartDistance> answers) const noexcept {
    for (std::size_t i = 0; i < points.size(); ++i) answers[i] = sample(points[i]);
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
    // No point is nearer than the middle is, less the way to it.
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
