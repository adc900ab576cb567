// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/field/part_field_layers.h"

#include <vector>

namespace burin {

/// Signed distance and gradient at a grid point, both in voxels: the gradient has no unit.
struct PartSample {
    float distance = 0.0F;
    glm::vec3 gradient{0.0F};
};

/// Asks a mesh for one place after the other. A place near the last one is answered faster: what was nearest to that
/// one bounds the distance. One thread each.
class PartAsker {
public:
    PartAsker(const MeshDistance& part, const glm::dvec3& origin, double voxel) noexcept
        : part_(part), origin_(origin), voxel_(voxel) {}

    /// @param place  in voxels from the origin
    PartSample ask(const glm::dvec3& place);
    PartSample ask(const glm::ivec3& place) { return ask(glm::dvec3(place)); }

private:
    const MeshDistance& part_;
    glm::dvec3 origin_;
    double voxel_;
    glm::dvec3 last_{0.0}; ///< a point of the mesh
    bool any_ = false;
};

/// All samples of a brick of cells, component by component.
struct SampleGrid {
    explicit SampleGrid(int along) : side(along) {
        for (std::vector<float>& component : values) component.resize(static_cast<std::size_t>(along * along * along));
    }
    int side;                                 ///< samples along an axis
    std::array<std::vector<float>, 4> values; ///< distance, then the gradient; x runs fastest
    std::size_t at(int x, int y, int z) const noexcept { return static_cast<std::size_t>(x + side * (y + side * z)); }
    void set(std::size_t place, const PartSample& sample) noexcept {
        values[0][place] = sample.distance;
        for (int axis = 0; axis < 3; ++axis) values[static_cast<std::size_t>(axis) + 1][place] = sample.gradient[axis];
    }
    PartSample get(std::size_t place) const noexcept {
        return {values[0][place], {values[1][place], values[2][place], values[3][place]}};
    }
};

/// How far lines between samples are from being smooth, voxels.
struct LineCheck {
    float bend = 0.0F;                                     ///< how far the middle lies from the chord
    float bends = 0.0F;                                    ///< the largest bend of each axis, added
    float residual = 0.0F;                                 ///< by how much the mean slope misses the other end
    float floor = -std::numeric_limits<float>::infinity(); ///< lines that lie below it altogether do not count
};

/// The grid with samples in between: 2 n - 1 along each axis, by cubics (Hermite) along x, y and z in turn.
/// @param spacing  of `coarse`, voxels  @param check  takes the largest of all lines
void refine(const SampleGrid& coarse, SampleGrid& fine, float spacing, LineCheck& check);

} // namespace burin
