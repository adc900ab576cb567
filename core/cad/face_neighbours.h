// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/triangle_mesh.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

namespace burin {

/// Tells which triangles of a mesh lie on one face: those connected without a bend of more than 20 degrees, which users
/// take for one face of a B-rep or of a mesh. Bit-identical vertices count as one. Keeps a reference to the mesh.
class FaceNeighbours {
public:
    explicit FaceNeighbours(const TriangleMesh& mesh);

    /// Returns the first vertex at the position of a corner. @param which 0 … 3, where 3 is the first corner again
    std::uint32_t corner(std::size_t triangle, int which) const;
    glm::dvec3 normal(std::size_t triangle) const; ///< unit vector; zero for a triangle without area
    /// Returns the triangle across a side. Empty if the face ends there. @param side 0 … 2, number of its start corner
    std::optional<std::size_t> beside(std::size_t triangle, int side) const;

private:
    static std::uint64_t sideFrom(std::uint32_t corner, std::uint32_t next) {
        return std::uint64_t{corner} << 32 | next;
    }

    const TriangleMesh& mesh_;
    std::vector<std::uint32_t> places_;
    std::unordered_map<std::uint64_t, std::uint32_t> sides_; ///< triangle of each directed side
};

} // namespace burin
