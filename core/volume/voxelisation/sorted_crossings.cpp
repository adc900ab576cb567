// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/voxelisation/sorted_crossings.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <utility>

namespace burin {

namespace {

constexpr std::size_t trianglesPerPart = std::size_t{1} << 14; // their crossings fit into the cache
constexpr int cellBits = 18;                                   // cells in a row of bricks: 32,768 lines times eight

/// A hash of an undirected edge (Murmur's last steps).
std::uint64_t markOf(std::uint32_t a, std::uint32_t b) noexcept {
    std::uint64_t mark = (std::uint64_t{std::min(a, b)} << 32 | std::max(a, b)) * 0xff51afd7ed558ccdU;
    mark ^= mark >> 33;
    mark *= 0xc4ceb9fe1a85ec53U;
    return mark ^ mark >> 29;
}

std::size_t rowCount(const Grid& grid) noexcept {
    return static_cast<std::size_t>((grid.lineCountV() + brickSide - 1) / brickSide);
}

} // namespace

SortedCrossings::SortedCrossings(const TriangleMesh& mesh, std::size_t firstCap, const Grid& grid,
                                 std::vector<LatticeVertex> vertices)
    : mesh_(&mesh)
    , firstCap_(firstCap)
    , grid_(grid)
    , vertices_(std::move(vertices))
    , parts_((mesh.triangles.size() + trianglesPerPart - 1) / trianglesPerPart) {
    parallelIntervals(std::size_t{0}, parts_.size(), 1, [&](std::size_t from, std::size_t to) {
        Scratch scratch;
        for (std::size_t i = from; i < to; ++i) parts_[i] = part(i * trianglesPerPart, scratch);
    });
    std::uint64_t edges = 0;
    for (const Part& part : parts_) edges ^= part.edges;
    closed_ = edges == 0;
}

TriangleCover SortedCrossings::cover(std::size_t triangle, const LineRectangle& range) const noexcept {
    const auto& [a, b, c] = mesh_->triangles[triangle];
    return {vertices_[a], vertices_[b], vertices_[c], range};
}

/// Calls visit(u, v, LineCrossing).
template <class Visit>
void SortedCrossings::cross(const TriangleCover& cover, std::size_t triangle, Visit&& visit) const {
    const bool cap = triangle >= firstCap_;
    const double beyond = static_cast<double>(grid_.lineEnd()) + 1.0;
    cover.forEachLine(-1.0, beyond, [&](std::int32_t u, std::int32_t v, double along, bool leaves) {
        const auto position = static_cast<std::int32_t>(along + 1.5) - 1; // to the nearest; never below -1
        visit(u, v, LineCrossing(position, leaves, cap));
    });
}

SortedCrossings::Part SortedCrossings::part(std::size_t first, Scratch& scratch) const {
    constexpr std::int64_t manyLines = 256;
    const LineRectangle all{0, 0, grid_.lineCountU(), grid_.lineCountV()};
    const std::size_t end = std::min(first + trianglesPerPart, mesh_->triangles.size());
    Part part;
    scratch.crossings.clear();
    scratch.large.clear();
    for (std::size_t t = first; t < end; ++t) {
        const auto& [a, b, c] = mesh_->triangles[t];
        part.edges ^= markOf(a, b) ^ markOf(b, c) ^ markOf(c, a);
        const TriangleCover covered = cover(t, all);
        const LineRectangle& lines = covered.lines();
        if (lines.empty()) continue;
        if (std::int64_t{lines.highU - lines.lowU} * (lines.highV - lines.lowV) > manyLines) {
            for (std::int32_t row = lines.lowV / brickSide; row <= (lines.highV - 1) / brickSide; ++row)
                scratch.large.push_back({static_cast<std::uint32_t>(t), static_cast<std::uint32_t>(row)});
            continue;
        }
        cross(covered, t, [&](std::int32_t u, std::int32_t v, LineCrossing crossing) {
            const std::uint32_t row = static_cast<std::uint32_t>(v) / brickSide;
            scratch.crossings.push_back({row << cellBits | CrossingCells::cellOf(u, v % brickSide), crossing});
        });
    }
    part.crossings = sorted(scratch.crossings, [](const Placed& placed) { return placed.place >> cellBits; });
    part.large = sorted(scratch.large, [](const LargeTriangle& large) { return large.row; });
    return part;
}

template <class Thing, class Row>
SortedCrossings::ByRow<Thing> SortedCrossings::sorted(const std::vector<Thing>& things, Row row) const {
    ByRow<Thing> result;
    result.firsts.resize(rowCount(grid_) + 1);
    for (const Thing& thing : things) ++result.firsts[row(thing) + 1];
    for (std::size_t i = 0; i + 1 < result.firsts.size(); ++i) result.firsts[i + 1] += result.firsts[i];
    std::vector<std::uint32_t> next(result.firsts.begin(), result.firsts.end() - 1);
    result.things.resize(things.size());
    for (const Thing& thing : things) result.things[next[row(thing)]++] = thing;
    return result;
}

void SortedCrossings::collect(std::int32_t row, CrossingCells& cells) const {
    const LineRectangle range{0, row * brickSide, grid_.lineCountU(),
                              std::min((row + 1) * brickSide, grid_.lineCountV())};
    for (const Part& part : parts_) {
        constexpr std::uint32_t cell = (1U << cellBits) - 1;
        for (const Placed& placed : part.crossings.in(row)) cells.add(placed.place & cell, placed.crossing);
        for (const LargeTriangle& large : part.large.in(row))
            cross(cover(large.triangle, range), large.triangle,
                  [&](std::int32_t u, std::int32_t v, LineCrossing crossing) {
                      cells.add(CrossingCells::cellOf(u, v - range.lowV), crossing);
                  });
    }
    cells.finish();
}

} // namespace burin
