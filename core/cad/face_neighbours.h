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

/// Which triangles of a mesh lie on one face: what is reached without a bend of more than 20 degrees, which is what
/// hands and eyes take for one face of a B-rep or of a mesh. Vertices that are bit-identical count as one. Keeps a
/// reference to the mesh.
class FaceNeighbours {
public:
    explicit FaceNeighbours(const TriangleMesh& mesh);

    /// A corner by the first vertex that lies there. @param which 0 … 3, where 3 is the first again
    std::uint32_t corner(std::size_t triangle, int which) const;
    glm::dvec3 normal(std::size_t triangle) const; ///< unit; zero of a triangle without area
    /// The triangle behind a side, unless the face ends there. @param side 0 … 2, from the corner of that number on
    std::optional<std::size_t> beside(std::size_t triangle, int side) const;

private:
    static std::uint64_t sideFrom(std::uint32_t corner, std::uint32_t next) {
        return std::uint64_t{corner} << 32 | next;
    }

    const TriangleMesh& mesh_;
    std::vector<std::uint32_t> places_;
    std::unordered_map<std::uint64_t, std::uint32_t> sides_; ///< of directed sides the triangle
};

} // namespace burin
