// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/triangle_bins.h"

#include "core/base/numbers.h"
#include "core/base/parallel.h"
#include "core/volume/brick_lines.h"

#include <algorithm>

namespace burin {

namespace {

constexpr std::size_t trianglesPerPart = std::size_t{1} << 16; // what is noted of them fits into the cache
constexpr std::size_t none = ~std::size_t{0};

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

TriangleBins::Part TriangleBins::sort(const TriangleMesh& mesh, const LatticeProjection& projection, const Grid& grid,
                                      std::size_t first, std::size_t end) {
    const LineRange all{0, 0, grid.lineCountU(), grid.lineCountV()};
    const auto rowCount = static_cast<std::size_t>((grid.lineCountV() + brickSide - 1) / brickSide);
    Part part;
    part.outOfReach = none;
    part.firsts.resize(rowCount + 1);
    std::vector<RowRange> rows(end - first);
    for (std::size_t t = first; t < end; ++t) {
        const auto& [ia, ib, ic] = mesh.triangles[t];
        const glm::dvec3 &a = mesh.vertices[ia], &b = mesh.vertices[ib], &c = mesh.vertices[ic];
        part.edges ^= markOf(ia, ib) ^ markOf(ib, ic) ^ markOf(ic, ia);
        if (!projection.reaches(a) || !projection.reaches(b) || !projection.reaches(c)) {
            part.outOfReach = t;
            return part;
        }
        const double ua = projection.u(a), ub = projection.u(b), uc = projection.u(c);
        const double va = projection.v(a), vb = projection.v(b), vc = projection.v(c);
        constexpr auto lattice = LatticeProjection::toLattice;
        const LineRange lines = linesWithin(lattice(std::min({ua, ub, uc})), lattice(std::min({va, vb, vc})),
                                            lattice(std::max({ua, ub, uc})), lattice(std::max({va, vb, vc})), all);
        if (lines.empty()) continue;
        RowRange& range = rows[t - first];
        range = {static_cast<std::uint16_t>(lines.lowV / brickSide),
                 static_cast<std::uint16_t>((lines.highV - 1) / brickSide)};
        for (std::size_t row = range.first; row <= range.last; ++row) ++part.firsts[row + 1];
    }
    for (std::size_t row = 0; row < rowCount; ++row) part.firsts[row + 1] += part.firsts[row];
    part.triangles.resize(part.firsts.back());
    std::vector<std::uint32_t> next(part.firsts.begin(), part.firsts.end() - 1);
    for (std::size_t t = first; t < end; ++t)
        for (std::size_t row = rows[t - first].first; row <= rows[t - first].last; ++row)
            part.triangles[next[row]++] = static_cast<std::uint32_t>(t);
    return part;
}

Result<TriangleBins> TriangleBins::make(const TriangleMesh& mesh, const Grid& grid) {
    const LatticeProjection projection(grid);
    TriangleBins bins;
    bins.parts_.resize((mesh.triangles.size() + trianglesPerPart - 1) / trianglesPerPart);
    parallelFor(std::size_t{0}, bins.parts_.size(), [&](std::size_t part) {
        const std::size_t first = part * trianglesPerPart;
        bins.parts_[part] =
            sort(mesh, projection, grid, first, std::min(first + trianglesPerPart, mesh.triangles.size()));
    });
    std::uint64_t edges = 0;
    for (const Part& part : bins.parts_) {
        edges ^= part.edges;
        if (part.outOfReach == none) continue;
        for (const std::uint32_t vertex : mesh.triangles[part.outOfReach])
            if (const glm::dvec3& point = mesh.vertices[vertex]; !projection.reaches(point))
                return Error{ErrorCode::argumentInvalid, "vertex",
                             formatShortest(point.x) + ", " + formatShortest(point.y) + ", " + formatShortest(point.z) +
                                 " mm",
                             "a finite place not beyond reach of the grid"};
    }
    bins.closed_ = edges == 0;
    return bins;
}

} // namespace burin
