// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/volume/voxelisation/crossing_cells.h"
#include "core/volume/voxelisation/line_crossings.h"

#include <span>
#include <vector>

namespace burin {

/// The crossings of scanlines with the triangles of a mesh, by row of bricks. Small triangles are intersected at once,
/// in the order of the mesh; for large ones only the rows that they reach are recorded. 8 bytes per crossing.
class SortedCrossings {
public:
    /// Parallel. @param firstCap  triangles from this index on only close holes. @throws std::bad_alloc
    SortedCrossings(const TriangleMesh& mesh, std::size_t firstCap, const Grid& grid,
                    std::vector<LatticeVertex> vertices);

    /// Adds the crossings of a row to the cells of their lines. Any thread.
    void collect(std::int32_t row, CrossingCells& cells) const;

    /// Whether every edge joins an even number of triangles (by vertex index), so that no line is crossed an odd number
    /// of times. The probability of taking an open mesh for closed is 2^-64.
    bool closed() const noexcept { return closed_; }

private:
    struct Placed {
        std::uint32_t place = 0; ///< cell in its row of bricks; the row in the bits above
        LineCrossing crossing;
    };
    /// Items sorted by row of bricks.
    template <class Thing>
    struct ByRow {
        std::vector<std::uint32_t> firsts; ///< and the end of the last
        std::vector<Thing> things;
        std::span<const Thing> in(std::int32_t row) const noexcept {
            const std::uint32_t first = firsts[static_cast<std::size_t>(row)];
            return std::span(things).subspan(first, firsts[static_cast<std::size_t>(row) + 1] - first);
        }
    };
    struct LargeTriangle {
        std::uint32_t triangle = 0, row = 0;
    };
    /// Consecutive triangles of the mesh.
    struct Part {
        ByRow<Placed> crossings;
        ByRow<LargeTriangle> large;
        std::uint64_t edges = 0; ///< sum modulo 2 of the hashes of all edges
    };
    struct Scratch {
        std::vector<Placed> crossings;
        std::vector<LargeTriangle> large;
    };

    Part part(std::size_t first, Scratch& scratch) const;
    template <class Thing, class Row>
    ByRow<Thing> sorted(const std::vector<Thing>& things, Row row) const;
    TriangleCover cover(std::size_t triangle, const LineRectangle& range) const noexcept;
    template <class Visit>
    void cross(const TriangleCover& cover, std::size_t triangle, Visit&& visit) const;

    const TriangleMesh* mesh_;
    std::size_t firstCap_;
    Grid grid_;
    std::vector<LatticeVertex> vertices_;
    std::vector<Part> parts_;
    bool closed_ = true;
};

} // namespace burin
