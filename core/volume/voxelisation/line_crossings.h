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

/// A vertex seen along the run axis of a grid: across it on an integer lattice of 1/65,536 voxel whose origin is the
/// centre of scanline (0, 0), so that which lines an edge has on which side is a matter of whole numbers. Triangles
/// that share an edge ask the same question and get the same answer: no line slips between them or hits both.
struct LatticeVertex {
    std::int64_t u = 0, v = 0;
    double along = 0.0; ///< run units from the low end of the grid
};

inline constexpr int latticeBits = 16;

/// Vertices of a mesh on the lattice of a grid. Parallel. Error: argumentInvalid for a vertex that is not finite or
/// 2^34 voxels or more away from the grid's low corner. @throws std::bad_alloc
Result<std::vector<LatticeVertex>> projectVertices(const TriangleMesh& mesh, const Grid& grid);

/// A rectangle of scanlines, half-open.
struct LineRectangle {
    std::int32_t lowU = 0, lowV = 0, highU = 0, highV = 0;
    bool empty() const noexcept { return lowU >= highU || lowV >= highV; }
};

/// Which scanlines pass through a triangle. A line on an edge belongs to one of the two triangles there: it counts as
/// moved by next to nothing along u, and by still less against v. Two ways, one answer: by the signs of the edges'
/// functions for small triangles, else by exact division of whole numbers.
class TriangleCover {
public:
    /// @param range only lines in it are looked at
    TriangleCover(const LatticeVertex& a, const LatticeVertex& b, const LatticeVertex& c,
                  const LineRectangle& range) noexcept;

    /// Lines that the triangle may cross. None: none passes through it.
    const LineRectangle& lines() const noexcept { return lines_; }

    /// Calls visit(u, v, along, leaves) for each line through the triangle: `along` in run units, between those of its
    /// corners; `leaves` where a line that runs upwards leaves an outward mesh. `lowest` and `highest` clamp `along`.
    template <class Visit>
    void forEachLine(double lowest, double highest, Visit&& visit) const;

private:
    static constexpr std::int32_t mostRows = 8, mostColumns = 16; ///< of a small one

    /// The lines of a small triangle: a bit for each, by row and by column.
    using Mask = std::array<std::uint32_t, mostRows>;
    struct Row {
        std::int32_t first = 0, end = 0;
        bool leaves = false;
    };
    struct Edge {
        std::int32_t value = 0, alongU = 0, alongV = 0; ///< inside where the value is not negative; its steps
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
