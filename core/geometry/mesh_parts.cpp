// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/mesh_parts.h"

#include <limits>
#include <utility>

namespace burin {

void place(TriangleMesh& mesh, const Placement& placement) {
    for (glm::dvec3& vertex : mesh.vertices) vertex = placement.point(vertex);
    if (mirrors(placement)) // counter-clockwise triangles became clockwise
        for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
}

std::vector<TriangleMesh> partsOf(const TriangleMesh& mesh, std::span<const std::uint32_t> partOf, std::size_t parts) {
    std::vector<TriangleMesh> split(parts);
    for (std::size_t i = 0; i < partOf.size(); ++i)
        if (partOf[i] < parts) split[partOf[i]].triangles.push_back(mesh.triangles[i]);
    constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> numbers(mesh.vertices.size(), none); // of vertices in the current part
    std::vector<std::uint32_t> used;
    for (TriangleMesh& part : split) {
        used.clear();
        for (auto& triangle : part.triangles)
            for (std::uint32_t& corner : triangle) {
                std::uint32_t& number = numbers[corner];
                if (number == none) {
                    number = static_cast<std::uint32_t>(used.size());
                    used.push_back(corner);
                    part.vertices.push_back(mesh.vertices[corner]);
                }
                corner = number;
            }
        for (const std::uint32_t vertex : used) numbers[vertex] = none;
    }
    return split;
}

} // namespace burin
