// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/run_volume.h"

#include <glm/glm.hpp>

#include <vector>

namespace burin {

/// Volume and moments of one body as its runs describe it: every run is a square prism of one voxel's width that ends
/// at 1/256 voxel. Setup frame.
struct BodyMoments {
    double volume = 0.0;      ///< mm³
    glm::dvec3 centroid{0.0}; ///< mm; meaningless when volume is 0
    /// Integral of (r - c)(r - c)ᵀ over the body, c its centroid, mm⁵; symmetric.
    glm::dmat3 secondMoments{0.0};

    /// Inertia about the centroid at density 1, mm⁵: the trace of the second moments on the diagonal, minus the second
    /// moments.
    glm::dmat3 inertia() const noexcept;
};

struct VolumeMoments {
    std::vector<BodyMoments> byProperty; ///< by entry of the property list; empty for air
    BodyMoments material;                ///< everything but air
};

/// Volume, centroid and second moments of every material. Sums are integers, so that the result does not depend on how
/// the work is divided among threads; exact but for the final rounding to double. Parallel; cost: grows with the
/// volume's runs.
/// @throws std::bad_alloc
VolumeMoments moments(const VolumeSnapshot& volume);

} // namespace burin
