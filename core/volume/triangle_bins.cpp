// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/triangle_bins.h"

#include "core/base/parallel.h"
#include "core/volume/brick_lines.h"

#include <algorithm>

namespace burin {

namespace {

constexpr std::size_t trianglesPerPart = std::size_t{1} << 16; // what is noted of them fits into the cache

/// Rows of bricks, inclusive; none when first > last.
struct RowRange {
    std::uint16_t first = 1, last = 0;
};

/// A number for an undirected edge that looks like chance (Murmur's last steps).
std::uint64_t markOf(std::uint32_t a, std::uint32_t b) noexcept {
    std::uint64_t mark = (std::uint64_t{std::min(a, b)} << 32 | std::max(a, b)) * 0xff51afd7ed558ccdU;
    mark ^= mark >> 33;
    mark *= 0xc4ceb9fe1a85ec53U;
    return mark ^ mark >> 29;
}

} // namespace

TriangleBins::Part TriangleBins::sort(std::span<const std::array<std::uint32_t, 3>> triangles, std::uint32_t first,
                                      const std::vector<LatticeVertex>& vertices, const Grid& grid) {
    const LineRange all{0, 0, grid.lineCountU(), grid.lineCountV()};
    const auto rowCount = static_cast<std::size_t>((grid.lineCountV() + brickSide - 1) / brickSide);
    Part part;
    part.firsts.resize(rowCount + 1);
    std::vector<RowRange> rows(triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        const auto& [a, b, c] = triangles[t];
        part.edges ^= markOf(a, b) ^ markOf(b, c) ^ markOf(c, a);
        const LineRange lines = TriangleCover(vertices[a], vertices[b], vertices[c], all).lines();
        if (lines.empty()) continue;
        rows[t] = {static_cast<std::uint16_t>(lines.lowV / brickSide),
                   static_cast<std::uint16_t>((lines.highV - 1) / brickSide)};
        for (std::size_t row = rows[t].first; row <= rows[t].last; ++row) ++part.firsts[row + 1];
    }
    for (std::size_t row = 0; row < rowCount; ++row) part.firsts[row + 1] += part.firsts[row];
    part.triangles.resize(part.firsts.back());
    std::vector<std::uint32_t> next(part.firsts.begin(), part.firsts.end() - 1);
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (std::size_t row = rows[t].first; row <= rows[t].last; ++row)
            part.triangles[next[row]++] = first + static_cast<std::uint32_t>(t);
    return part;
}

TriangleBins::TriangleBins(const TriangleMesh& mesh, const std::vector<LatticeVertex>& vertices, const Grid& grid)
    : parts_((mesh.triangles.size() + trianglesPerPart - 1) / trianglesPerPart) {
    parallelFor(std::size_t{0}, parts_.size(), [&](std::size_t part) {
        const std::size_t first = part * trianglesPerPart;
        const std::span all(mesh.triangles);
        parts_[part] = sort(all.subspan(first, std::min(trianglesPerPart, all.size() - first)),
                            static_cast<std::uint32_t>(first), vertices, grid);
    });
    std::uint64_t edges = 0;
    for (const Part& part : parts_) edges ^= part.edges;
    closed_ = edges == 0;
}

} // namespace burin
