// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <glm/glm.hpp>
#include <limits>
#include <vector>

namespace burin {

/// A distance and its gradient at a grid point. Both in the same unit of length (mm for a tool's clearance, voxels for
/// a part's distance), so that the gradient has no unit.
struct DistanceSample {
    float distance = 0.0F;
    glm::vec3 gradient{0.0F};
};

/// All samples of a brick of cells, stored by component.
struct SampleGrid {
    explicit SampleGrid(int along) : side(along) {
        for (std::vector<float>& component : values) component.resize(static_cast<std::size_t>(along * along * along));
    }
    int side;                                 ///< samples along an axis
    std::array<std::vector<float>, 4> values; ///< distance, then the gradient; x runs fastest
    std::size_t at(int x, int y, int z) const noexcept { return static_cast<std::size_t>(x + side * (y + side * z)); }
    void set(std::size_t place, const DistanceSample& sample) noexcept {
        values[0][place] = sample.distance;
        for (int axis = 0; axis < 3; ++axis) values[static_cast<std::size_t>(axis) + 1][place] = sample.gradient[axis];
    }
    DistanceSample get(std::size_t place) const noexcept {
        return {values[0][place], {values[1][place], values[2][place], values[3][place]}};
    }
};

/// Deviation from smoothness of the lines between samples, voxels.
struct LineCheck {
    float bend = 0.0F;                                     ///< largest deviation of a middle from its chord
    float bends = 0.0F;                                    ///< sum over the axes of the largest bend of each
    float residual = 0.0F;                                 ///< error when the mean slope predicts the other end
    float floor = -std::numeric_limits<float>::infinity(); ///< lines that lie completely below it do not count
};

/// The grid with additional samples in between: 2 n - 1 along each axis, by cubics (Hermite) along x, y and z in turn.
/// @param spacing  of `coarse`, voxels  @param check  receives the largest values of all lines
void refine(const SampleGrid& coarse, SampleGrid& fine, float spacing, LineCheck& check);

} // namespace burin
