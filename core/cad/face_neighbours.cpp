// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/face_neighbours.h"

#include "core/geometry/triangle.h"

namespace burin {

namespace {

constexpr double leastCosine = 0.9397; // cosine of 20 degrees, the largest bend within a face

} // namespace

FaceNeighbours::FaceNeighbours(const TriangleMesh& mesh) : mesh_(mesh), places_(firstAtSamePlace(mesh)) {
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        for (int side = 0; side < 3; ++side)
            sides_.emplace(sideFrom(corner(i, side), corner(i, side + 1)), static_cast<std::uint32_t>(i));
}

std::uint32_t FaceNeighbours::corner(std::size_t triangle, int which) const {
    return places_[mesh_.triangles[triangle][static_cast<std::size_t>(which % 3)]];
}

glm::dvec3 FaceNeighbours::normal(std::size_t triangle) const {
    return unitNormal(cornersOf(mesh_, triangle));
}

std::optional<std::size_t> FaceNeighbours::beside(std::size_t triangle, int side) const {
    const auto found = sides_.find(sideFrom(corner(triangle, side + 1), corner(triangle, side)));
    if (found == sides_.end() || glm::dot(normal(triangle), normal(found->second)) < leastCosine) return {};
    return found->second;
}

} // namespace burin
