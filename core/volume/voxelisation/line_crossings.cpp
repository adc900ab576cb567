// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/volume/voxelisation/line_crossings.h"

#include "core/base/numbers.h"
#include "core/base/parallel.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <utility>

namespace burin {

namespace {

__extension__ using Wide = __int128;

constexpr std::int64_t one = std::int64_t{1} << latticeBits;

template <class Integer>
Integer ceilDivide(Integer numerator, Integer denominator) noexcept { // denominator > 0
    const Integer quotient = numerator / denominator;
    return quotient + (numerator % denominator > 0 ? 1 : 0);
}

/// The first scanline u at or beyond the crossing of the edge with row v: exact, and the same from both sides.
std::int64_t firstLineBeyond(std::int64_t fromU, std::int64_t fromV, std::int64_t toU, std::int64_t toV,
                             std::int64_t v) noexcept {
    if (fromV > toV) {
        std::swap(fromU, toU);
        std::swap(fromV, toV);
    }
    const std::int64_t du = toU - fromU, dv = toV - fromV;
    const std::int64_t whole = fromU >> latticeBits, fraction = fromU & (one - 1);
    constexpr std::int64_t small = std::int64_t{1} << 30; // products and their sums below stay within 63 bits
    if (du > -small && du < small && dv < small)
        return whole + ceilDivide(ceilDivide((v - fromV) * du, dv) + fraction, one);
    const Wide crossing = ceilDivide<Wide>(Wide{v - fromV} * du, dv);
    return whole + static_cast<std::int64_t>(ceilDivide<Wide>(crossing + fraction, one));
}

} // namespace

Result<std::vector<LatticeVertex>> projectVertices(const TriangleMesh& mesh, const Grid& grid) {
    struct Axis {
        int index;
        double low;
    };
    const auto axisAt = [&](int index) { return Axis{index, grid.low()[index]}; };
    const Axis axisU = axisAt(grid.axisOfU()), axisV = axisAt(grid.axisOfV()), runs = axisAt(grid.axisOfRuns());
    const double voxelsPerMillimetre = 1.0 / grid.edge();
    const auto voxels = [&](const glm::dvec3& point, const Axis& axis) {
        return (glm::value_ptr(point)[axis.index] - axis.low) * voxelsPerMillimetre; // operator[] would branch
    };
    // Differences on the lattice then stay below 2^52 and are also exact in double precision.
    constexpr double reach = static_cast<double>(std::int64_t{1} << 34);
    const auto reached = [](double x) { return std::abs(x) < reach; }; // false for NaN
    const auto lattice = [](double x) {
        constexpr double wholeFromHere = 0x1.8p52; // doubles from here on have no fraction; valid below 2^51
        return std::bit_cast<std::int64_t>((x - 0.5) * static_cast<double>(one) + wholeFromHere) -
               std::bit_cast<std::int64_t>(wholeFromHere);
    };
    std::vector<LatticeVertex> vertices(mesh.vertices.size());
    std::atomic<const glm::dvec3*> outOfReach{nullptr};
    parallelIntervals(std::size_t{0}, vertices.size(), 1 << 14, [&](std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < to; ++i) {
            const glm::dvec3& point = mesh.vertices[i];
            const double u = voxels(point, axisU), v = voxels(point, axisV), along = voxels(point, runs);
            if (!(reached(u) && reached(v) && reached(along))) outOfReach = &point;
            vertices[i] = {lattice(u), lattice(v), along * unitsPerVoxel};
        }
    });
    if (const glm::dvec3* const point = outOfReach)
        return Error{ErrorCode::argumentInvalid, "vertex",
                     formatShortest(point->x) + ", " + formatShortest(point->y) + ", " + formatShortest(point->z) +
                         " mm",
                     "a finite position within reach of the grid"};
    return vertices;
}

TriangleCover::Row TriangleCover::row(std::int32_t index) const noexcept {
    const std::int64_t v = std::int64_t{index} << latticeBits;
    // An edge crosses the row if one end lies below it and the other on it or above: two edges do, or none.
    std::int64_t upwards = 0, downwards = 0;
    const std::array points{&a_, &b_, &c_};
    for (std::size_t i = 0; i < 3; ++i) {
        const LatticeVertex &from = *points[i], &to = *points[(i + 1) % 3];
        if ((from.v < v) == (to.v < v)) continue;
        (from.v < v ? upwards : downwards) = firstLineBeyond(from.u, from.v, to.u, to.v, v);
    }
    const auto clamped = [&](std::int64_t line) {
        return static_cast<std::int32_t>(std::clamp<std::int64_t>(line, lines_.lowU, lines_.highU));
    };
    // Seen against the run direction a counter-clockwise triangle goes up on its right: it faces along the runs, so the
    // line leaves.
    return {clamped(std::min(upwards, downwards)), clamped(std::max(upwards, downwards)), downwards < upwards};
}

} // namespace burin
