// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/field/sample_grid.h"
#include "core/geometry/mesh_distance.h"
#include "tests/part_field/part_asker.h"

namespace burin {

/// Queries a mesh for one point after the other. A point near the previous one is answered faster: the nearest point of
/// the previous query bounds the distance. Not thread-safe: use one object per thread.
class PartAsker {
public:
    PartAsker(const MeshDistance& part, const glm::dvec3& origin, double voxel) noexcept
        : part_(part), origin_(origin), voxel_(voxel) {}

    /// @param place  in voxels from the origin
    DistanceSample ask(const glm::dvec3& place);
    DistanceSample ask(const glm::ivec3& place) { return ask(glm::dvec3(place)); }

private:
    const MeshDistance& part_;
    glm::dvec3 origin_;
    double voxel_;
    glm::dvec3 last_{0.0}; ///< a point of the mesh
    bool any_ = false;
};

} // namespace burin
