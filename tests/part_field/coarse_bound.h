// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/field/sample_grid.h"
#include "tests/part_field/part_field_layers.h"

namespace burin {

/// Bounds of the distances in a cube, derived from its eight corners, in voxels.
struct CoarseBound {
    float error = 0.0F; ///< largest error of a value between the corners
    float least = 0.0F; ///< lower bound of the distance from any point of the cube to the surface
};

/// @param corners samples, x running fastest, exact @param edge of the cube
CoarseBound coarseBound(const std::array<DistanceSample, 8>& corners, float edge) noexcept;

/// Whether the distance may be `distance` or less somewhere in a cube, judged by its corners: the point of the surface
/// nearest to such a point is at most that far from the cube's face, whose corners are at most half a diagonal of the
/// face away.
bool mayBeWithin(const std::array<DistanceSample, 8>& corners, float edge, float distance) noexcept;

} // namespace burin
