// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/geometry/triangle_mesh.h"
#include "core/volume/runs/grid.h"

#include <array>
#include <cstdint>
#include <vector>

namespace burin {

/// A vertex projected along the run axis of a grid: across it on an integer lattice of 1/65,536 voxel whose origin is
/// the centre of scanline (0, 0), so that which lines lie on which side of an edge is decided in integer arithmetic.
/// Triangles that share an edge evaluate the same expression and get the same result: no line passes between them or
/// meets both.
struct LatticeVertex {
    std::int64_t u = 0, v = 0;
    double along = 0.0; ///< run units from the low end of the grid
};

inline constexpr int latticeBits = 16;

/// The vertices of a mesh on the lattice of a grid. Parallel. Errors: argumentInvalid for a vertex that is not finite
/// or is 2^34 voxels or more away from the grid's low corner. @throws std::bad_alloc
Result<std::vector<LatticeVertex>> projectVertices(const TriangleMesh& mesh, const Grid& grid);

/// A rectangle of scanlines, half-open.
struct LineRectangle {
    std::int32_t lowU = 0, lowV = 0, highU = 0, highV = 0;
    bool empty() const noexcept { return lowU >= highU || lowV >= highV; }
};

/// Which scanlines pass through a triangle. A line on an edge belongs to exactly one of the two triangles there: it is
/// treated as if displaced by an infinitesimal distance along u, and by a still smaller one against v. Two methods with
/// the same result: the signs of the edge functions for small triangles, otherwise exact integer division.
class TriangleCover {
public:
    /// @param range  only lines in it are considered
    TriangleCover(const LatticeVertex& a, const LatticeVertex& b, const LatticeVertex& c,
                  const LineRectangle& range) noexcept;

    /// Lines that the triangle may cross. If empty, no line passes through it.
    const LineRectangle& lines() const noexcept { return lines_; }

    /// Calls visit(u, v, along, leaves) for each line through the triangle: `along` in run units, between those of its
    /// corners; `leaves` if a line that runs upwards leaves an outward-oriented mesh. `lowest` and `highest` clamp
    /// `along`.
    template <class Visit>
    void forEachLine(double lowest, double highest, Visit&& visit) const;

private:
    static constexpr std::int32_t mostRows = 8, mostColumns = 16; ///< of a small triangle

    /// The lines of a small triangle: one bit each, by row and by column.
    using Mask = std::array<std::uint32_t, mostRows>;
    struct Row {
        std::int32_t first = 0, end = 0;
        bool leaves = false;
    };
    struct Edge {
        std::int32_t value = 0, alongU = 0, alongV = 0; ///< inside if the value is not negative; its increments
    };
    class Plane;

    bool isSmall() const noexcept;
    std::uint32_t mask(std::int64_t area, Mask& rows) const noexcept;
    Edge edge(const LatticeVertex& from, const LatticeVertex& to) const noexcept;
    Row row(std::int32_t v) const noexcept;

    LatticeVertex a_, b_, c_;
    LineRectangle lines_;
};

} // namespace burin

#include "core/volume/voxelisation/line_crossings_impl.h"
