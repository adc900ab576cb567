// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/property_list.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <vector>

namespace burin::test {

/// One property for each whole voxel, in the order of `fromDense`: the paper's voxel array, for direct look-up.
struct DenseVoxels {
    explicit DenseVoxels(glm::ivec3 size) : count(size), properties(total()) {}

    glm::ivec3 count;
    std::vector<PropertyIndex> properties;

    std::size_t total() const { return static_cast<std::size_t>(count.x * count.y * count.z); }
    bool contains(glm::ivec3 voxel) const {
        return glm::all(glm::greaterThanEqual(voxel, glm::ivec3(0))) && glm::all(glm::lessThan(voxel, count));
    }
    PropertyIndex& at(glm::ivec3 voxel) { return properties[place(voxel)]; }
    /// Air outside the grid.
    PropertyIndex at(glm::ivec3 voxel) const { return contains(voxel) ? properties[place(voxel)] : airProperty; }

    /// Calls visit(voxel) for each voxel within one step, including the voxel itself and voxels outside the grid.
    template <class Visit>
    static void around(glm::ivec3 voxel, Visit visit) {
        for (int k = -1; k <= 1; ++k)
            for (int j = -1; j <= 1; ++j)
                for (int i = -1; i <= 1; ++i) visit(voxel + glm::ivec3(i, j, k));
    }
    template <class Visit>
    void each(Visit visit) const {
        for (int k = 0; k < count.z; ++k)
            for (int j = 0; j < count.y; ++j)
                for (int i = 0; i < count.x; ++i) visit(glm::ivec3(i, j, k));
    }

private:
    std::size_t place(glm::ivec3 voxel) const {
        return static_cast<std::size_t>((voxel.z * count.y + voxel.y) * count.x + voxel.x);
    }
};

} // namespace burin::test
