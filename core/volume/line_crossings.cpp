// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/line_crossings.h"

#include "core/base/numbers.h"

#include <utility>

namespace burin {

namespace {

__extension__ using Wide = __int128;

constexpr std::int64_t one = std::int64_t{1} << ProjectedMesh::fractionBits;

template <class Integer>
Integer ceilDivide(Integer numerator, Integer denominator) noexcept { // denominator > 0
    const Integer quotient = numerator / denominator;
    return quotient + (numerator % denominator > 0 ? 1 : 0);
}

/// The first scanline u at or beyond the place where the edge crosses row v: exact, the same from both sides.
std::int64_t firstLineBeyond(std::int64_t fromU, std::int64_t fromV, std::int64_t toU, std::int64_t toV,
                             std::int64_t v) noexcept {
    if (fromV > toV) {
        std::swap(fromU, toU);
        std::swap(fromV, toV);
    }
    const std::int64_t du = toU - fromU, dv = toV - fromV;
    const std::int64_t whole = fromU >> ProjectedMesh::fractionBits, fraction = fromU & (one - 1);
    constexpr std::int64_t small = std::int64_t{1} << 30; // products and their sums below stay within 63 bits
    if (du > -small && du < small && dv < small)
        return whole + ceilDivide(ceilDivide((v - fromV) * du, dv) + fraction, one);
    const Wide crossing = ceilDivide<Wide>(Wide{v - fromV} * du, dv);
    return whole + static_cast<std::int64_t>(ceilDivide<Wide>(crossing + fraction, one));
}

std::int32_t clampLine(std::int64_t line, std::int32_t count) noexcept {
    return static_cast<std::int32_t>(std::clamp<std::int64_t>(line, 0, count));
}

} // namespace

Result<ProjectedMesh> ProjectedMesh::make(const TriangleMesh& mesh, const Grid& grid) {
    // 2^35 voxels: differences on the lattice then stay below 2^53 and are exact in double precision, too.
    constexpr double reach = static_cast<double>(std::int64_t{1} << 35);
    ProjectedMesh projected;
    projected.mesh_ = &mesh;
    projected.lineCountU_ = grid.lineCountU();
    projected.lineCountV_ = grid.lineCountV();
    projected.vertices_.reserve(mesh.vertices.size());
    const double voxelsPerMillimetre = 1.0 / grid.edge();
    for (const glm::dvec3& point : mesh.vertices) {
        const glm::dvec3 place = (point - grid.low()) * voxelsPerMillimetre;
        for (int axis = 0; axis < 3; ++axis)
            if (!(std::abs(place[axis]) < reach)) // catches what is not a number, too
                return Error{ErrorCode::argumentInvalid, "vertex", formatShortest(point[axis]) + " mm",
                             "a finite place not beyond reach of the grid"};
        const auto lattice = [](double voxels) { return std::llround((voxels - 0.5) * static_cast<double>(one)); };
        projected.vertices_.push_back(
            {lattice(place[grid.axisOfU()]), lattice(place[grid.axisOfV()]), place[grid.axisOfRuns()] * unitsPerVoxel});
    }
    return projected;
}

ProjectedMesh::Rows ProjectedMesh::rows(std::size_t triangle) const noexcept {
    const auto points = corners(triangle);
    const auto [low, high] = std::minmax({points[0].v, points[1].v, points[2].v});
    return {clampLine((low >> fractionBits) + 1, lineCountV_), clampLine((high >> fractionBits) + 1, lineCountV_)};
}

ProjectedMesh::Cover ProjectedMesh::cover(const std::array<Vertex, 3>& points, std::int32_t row) const noexcept {
    const std::int64_t v = std::int64_t{row} << fractionBits;
    // An edge crosses the row when one end lies below it and the other on it or above: two edges do, or none.
    std::int64_t upwards = 0, downwards = 0;
    bool crossed = false;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vertex &from = points[i], &to = points[(i + 1) % 3];
        if ((from.v < v) == (to.v < v)) continue;
        (from.v < v ? upwards : downwards) = firstLineBeyond(from.u, from.v, to.u, to.v, v);
        crossed = true;
    }
    if (!crossed) return {};
    // Seen against the runs a counter-clockwise triangle goes up on its right: it faces along the runs, the line
    // leaves.
    const bool leaves = downwards < upwards;
    return {clampLine(std::min(upwards, downwards), lineCountU_), clampLine(std::max(upwards, downwards), lineCountU_),
            leaves ? -1 : 1};
}

} // namespace burin
