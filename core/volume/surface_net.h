// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/surface_field.h"

#include <array>
#include <cstdint>
#include <vector>

namespace burin {

/// Surface nets (Gibson 1998): one point for every cube of eight nodes that the surface crosses, in the middle of the
/// crossings on its edges, and a quadrangle around every crossed edge. A tile owns the edges that start at its own
/// nodes; the points beside its border come out alike in both tiles.
class SurfaceNet {
public:
    /// Adds what one filled interval of a field holds: points, normals from the field's gradient, triangles.
    /// Properties are left to the caller.
    void add(const SurfaceField& field, const Grid& grid, SurfaceMesh& mesh);

private:
    struct Edge {
        int axis = 0; ///< 0, 1, 2: along u, v, the runs
        int u = 0, v = 0, n = 0;
        bool outwards = true; ///< the node at its start is inside
    };

    void findInside();
    void addPoints(SurfaceMesh& mesh);
    void addPoint(int u, int v, int n, SurfaceMesh& mesh);
    void addFaces(SurfaceMesh& mesh) const;
    void addFace(const Edge& edge, SurfaceMesh& mesh) const;
    std::uint32_t pointOf(int u, int v, int n) const {
        return pointOfCube_[static_cast<std::size_t>(u * columnsV_ + v) * static_cast<std::size_t>(count_) +
                            static_cast<std::size_t>(n)];
    }
    const std::uint64_t* insideOf(int u, int v) const {
        return inside_.data() + static_cast<std::size_t>(u * columnsV_ + v) * words_;
    }
    template <class Visit>
    void crossings(int u, int v, int otherU, int otherV, Visit visit) const;

    const SurfaceField* field_ = nullptr;
    int columnsU_ = 0, columnsV_ = 0, count_ = 0;
    std::vector<std::uint64_t> ownedNodes_; ///< a bit a node whose edges are drawn
    std::vector<std::uint64_t> ownedCubes_; ///< a bit a cube that touches one of them
    std::array<int, 3> axes_{};             ///< x, y or z of u, v and the runs
    glm::dvec3 low_{0.0};                   ///< mm, of the grid along those
    double size_ = 1.0;                     ///< mm, of a cell
    std::size_t words_ = 0;
    std::vector<std::uint64_t> inside_;      ///< a bit a node, by column
    std::vector<std::uint32_t> pointOfCube_; ///< by the cube's lowest node; set where the surface crosses
};

} // namespace burin
