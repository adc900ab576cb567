// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/box.h"
#include "core/geometry/triangle.h"
#include "core/geometry/triangle_mesh.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace burin {

/// Four boxes side by side, single precision, relative to the tree's origin and rounded outwards, so that what is
/// outside a box here is outside the true one. Each box also has a plate: its content also lies between two planes and
/// within `radius` of the box's centre. Surfaces are thin in the direction of their own normal, not of the axes.
struct alignas(64) TreeNode {
    static constexpr std::size_t width = 4;
    using Floats = std::array<float, width>; ///< one per child

    std::array<Floats, 3> low; ///< [axis][child]
    std::array<Floats, 3> high;
    std::array<std::uint32_t, width> first; ///< a leaf's first triangle, or a node
    std::array<std::uint32_t, width> count; ///< a leaf's triangles; 0: `first` is a node. Unused children: empty box.
    std::array<Floats, 3> normal;           ///< unit, [axis][child]
    Floats below, above;                    ///< along the normal from the box's centre: below <= 0 <= above
    Floats radius;
};

/// Bounding volume hierarchy over triangles, four children a node, at most four triangles a leaf, split by the surface
/// area heuristic (binned: I. Wald, On fast construction of SAH-based bounding volume hierarchies, 2007).
class TriangleTree {
public:
    static constexpr std::size_t trianglesPerLeaf = 4;
    /// Maximum number of open entries of a depth-first walk.
    static constexpr std::size_t stackSize = 256;

    /// @param places  indices of the triangles to use, in the mesh. They are stored in the tree's own order:
    ///        `order()[slot]` is the index of `triangles()[slot]` in the mesh.
    TriangleTree(const TriangleMesh& mesh, std::span<const std::uint32_t> places);

    bool empty() const noexcept { return order_.empty(); }
    std::span<const TreeNode> nodes() const noexcept { return nodes_; } ///< the root is the first
    std::span<const Triangle> triangles() const noexcept { return {triangles_.get(), order_.size()}; }
    std::span<const std::uint32_t> order() const noexcept { return order_; }
    const glm::dvec3& origin() const noexcept { return origin_; } ///< of the nodes' boxes, mm, the mesh's frame
    const Box& bounds() const noexcept { return bounds_; }        ///< mm, the mesh's frame

private:
    std::vector<TreeNode> nodes_;
    std::unique_ptr<Triangle[]> triangles_; ///< not a vector, which would first be cleared, on one core
    std::vector<std::uint32_t> order_;
    glm::dvec3 origin_{0.0};
    Box bounds_;
};

} // namespace burin
