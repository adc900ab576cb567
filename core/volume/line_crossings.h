// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/volume/grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace burin {

/// Where a scanline's centre passes through a triangle.
struct LineCrossing {
    std::int32_t position = 0; ///< run units from the low end of the grid; may lie outside of it
    std::int32_t turn = 0;     ///< +1 where a line that runs upwards enters an outward mesh, -1 where it leaves
};

/// A mesh seen along the run axis of a grid: vertices across it on an integer lattice of 1/65,536 voxel whose origin is
/// the centre of scanline (0, 0), so that which lines an edge has on which side is a matter of whole numbers. The two
/// triangles at an edge ask the same question and get the same answer: no line slips between them or hits both.
class ProjectedMesh {
public:
    static constexpr int fractionBits = 16;

    /// Error: argumentInvalid for a vertex that the lattice can't hold.
    static Result<ProjectedMesh> make(const TriangleMesh& mesh, const Grid& grid);

    /// Scanlines v that a triangle may cross: first <= v < end, within the grid.
    struct Rows {
        std::int32_t first = 0, end = 0;
    };
    Rows rows(std::size_t triangle) const noexcept;

    /// Calls visit(u, LineCrossing) for each scanline of row v whose centre passes through the triangle.
    template <class Visit>
    void forEachCrossing(std::size_t triangle, std::int32_t v, Visit&& visit) const;

    std::size_t triangleCount() const noexcept { return mesh_->triangles.size(); }

private:
    struct Vertex {
        std::int64_t u = 0, v = 0; ///< lattice
        double along = 0.0;        ///< run units
    };
    /// The lines u of a row that a triangle covers, first <= u < end, and which way it faces.
    struct Cover {
        std::int32_t first = 0, end = 0, turn = 0;
    };

    std::array<Vertex, 3> corners(std::size_t triangle) const noexcept {
        const auto& [a, b, c] = mesh_->triangles[triangle];
        return {vertices_[a], vertices_[b], vertices_[c]};
    }
    Cover cover(const std::array<Vertex, 3>& points, std::int32_t row) const noexcept;

    const TriangleMesh* mesh_ = nullptr;
    std::vector<Vertex> vertices_;
    std::int32_t lineCountU_ = 0, lineCountV_ = 0;
};

template <class Visit>
void ProjectedMesh::forEachCrossing(std::size_t triangle, std::int32_t v, Visit&& visit) const {
    const std::array<Vertex, 3> points = corners(triangle);
    const Cover covered = cover(points, v);
    if (covered.first >= covered.end) return;
    // The plane's height over the lattice, relative to the first corner to keep digits.
    const auto& [a, b, c] = points;
    const double bu = static_cast<double>(b.u - a.u), bv = static_cast<double>(b.v - a.v), bz = b.along - a.along;
    const double cu = static_cast<double>(c.u - a.u), cv = static_cast<double>(c.v - a.v), cz = c.along - a.along;
    const double area = bu * cv - bv * cu;
    const double slopeU = (bz * cv - cz * bv) / area, slopeV = (bu * cz - cu * bz) / area;
    const double low = std::min({a.along, b.along, c.along}), high = std::max({a.along, b.along, c.along});
    const double dv = static_cast<double>((std::int64_t{v} << fractionBits) - a.v);
    for (std::int32_t u = covered.first; u < covered.end; ++u) {
        const double du = static_cast<double>((std::int64_t{u} << fractionBits) - a.u);
        // A triangle seen nearly edge-on has slopes without meaning; its crossing lies between its corners all the
        // same.
        double along = a.along + slopeU * du + slopeV * dv;
        if (!(along >= low))
            along = low;
        else if (along > high)
            along = high;
        constexpr double farAway = 1 << 30;
        visit(u, LineCrossing{static_cast<std::int32_t>(std::floor(std::clamp(along, -farAway, farAway) + 0.5)),
                              covered.turn});
    }
}

} // namespace burin
