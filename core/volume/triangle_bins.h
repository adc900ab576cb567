// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/volume/line_crossings.h"

#include <span>
#include <vector>

namespace burin {

/// Which triangles of a mesh may cross scanlines of which row of bricks. Triangles that no line passes are left out.
class TriangleBins {
public:
    /// Parallel. @throws std::bad_alloc
    TriangleBins(const TriangleMesh& mesh, const std::vector<LatticeVertex>& vertices, const Grid& grid);

    /// Calls visit(triangle) for those of a row, in the mesh's order.
    template <class Visit>
    void forEachIn(std::int32_t row, Visit&& visit) const {
        for (const Part& part : parts_) {
            const std::uint32_t first = part.firsts[static_cast<std::size_t>(row)];
            for (const std::uint32_t triangle :
                 std::span(part.triangles).subspan(first, part.firsts[static_cast<std::size_t>(row) + 1] - first))
                visit(triangle);
        }
    }

    /// Whether every edge joins an even number of triangles (by vertex index), so that no line is crossed an odd number
    /// of times. A mesh that is not may be taken for closed once in 2^64.
    bool closed() const noexcept { return closed_; }

private:
    /// Triangles one after the other in the mesh, sorted by row.
    struct Part {
        std::vector<std::uint32_t> firsts; ///< by row, and the end
        std::vector<std::uint32_t> triangles;
        std::uint64_t edges = 0; ///< sum modulo 2 of all edges' marks
    };
    static Part sort(std::span<const std::array<std::uint32_t, 3>> triangles, std::uint32_t first,
                     const std::vector<LatticeVertex>& vertices, const Grid& grid);

    std::vector<Part> parts_;
    bool closed_ = true;
};

} // namespace burin
