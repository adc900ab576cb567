// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/field/sample_grid.h"
#include "tests/part_field/part_field_layers.h"

namespace burin {

/// What the eight corners of a cube tell of the distances in it, in voxels.
struct CoarseBound {
    float error = 0.0F; ///< of a value between the corners
    float least = 0.0F; ///< no point of the cube is nearer to the surface
};

/// @param corners  samples, x running fastest, exact  @param edge  of the cube
CoarseBound coarseBound(const std::array<DistanceSample, 8>& corners, float edge) noexcept;

/// Whether the distance may be `distance` or less somewhere in a cube, judged by its corners: a point so near has its
/// nearest one at most so far from the cube's face, whose corners are half a diagonal of the face away.
bool mayBeWithin(const std::array<DistanceSample, 8>& corners, float edge, float distance) noexcept;

} // namespace burin
