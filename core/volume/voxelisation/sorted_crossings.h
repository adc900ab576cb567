// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/volume/voxelisation/crossing_cells.h"
#include "core/volume/voxelisation/line_crossings.h"

#include <span>
#include <vector>

namespace burin {

/// Where scanlines cross the triangles of a mesh, by row of bricks. Small triangles are crossed here and now, in the
/// mesh's order; of large ones it is noted which rows they reach into. 8 bytes a crossing.
class SortedCrossings {
public:
    /// Parallel. @param firstCap triangles from here on only close holes. @throws std::bad_alloc
    SortedCrossings(const TriangleMesh& mesh, std::size_t firstCap, const Grid& grid,
                    std::vector<LatticeVertex> vertices);

    /// Puts those of a row into the cells of their lines. Any thread.
    void collect(std::int32_t row, CrossingCells& cells) const;

    /// Whether every edge joins an even number of triangles (by vertex index), so that no line is crossed an odd number
    /// of times. A mesh that is not may be taken for closed once in 2^64.
    bool closed() const noexcept { return closed_; }

private:
    struct Placed {
        std::uint32_t place = 0; ///< the cell in its row of bricks, above it the row
        LineCrossing crossing;
    };
    /// Things sorted by row of bricks.
    template <class Thing>
    struct ByRow {
        std::vector<std::uint32_t> firsts; ///< and the end
        std::vector<Thing> things;
        std::span<const Thing> in(std::int32_t row) const noexcept {
            const std::uint32_t first = firsts[static_cast<std::size_t>(row)];
            return std::span(things).subspan(first, firsts[static_cast<std::size_t>(row) + 1] - first);
        }
    };
    struct LargeTriangle {
        std::uint32_t triangle = 0, row = 0;
    };
    /// Triangles one after the other in the mesh.
    struct Part {
        ByRow<Placed> crossings;
        ByRow<LargeTriangle> large;
        std::uint64_t edges = 0; ///< sum modulo 2 of all edges' marks
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
