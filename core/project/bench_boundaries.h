// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/axis_mode.h"
#include "core/haptics/boundary_layers.h"
#include "core/machine/envelope.h"
#include "core/project/bench.h"
#include "core/setup/obstacle.h"

#include <span>

namespace burin {

/// What bounds a bench's tool besides the part.
struct Surroundings {
    std::vector<Obstacle> obstacles; ///< layers 1, 2, …
    Envelope envelope;               ///< the layer after them, where it sets a limit
};

/// What bounds the bench's tool, for HapticStep. The part is layer 0: a field of tips where the axis stands, the mesh
/// itself where it is free. The bench outlives it. Cost: that of `clearanceField`; with a free axis none.
/// Errors: cancelled, outOfMemory, argumentInvalid (an axis that is not of unit length).
Result<BoundaryLayers> boundaryLayers(const Bench& bench, const AxisMode& axis, const Surroundings& surroundings,
                                      double maximumAllowance, Progress& progress);

} // namespace burin
