// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cutting/surface_flux.h"

namespace burin {

/// The material around the flutes.
struct MetMaterial {
    Engagement engagement; ///< of the last tick that had an engagement
    double area = 0.0;     ///< mm², engaged area across the motion, as it is felt (EngagedArea)
    double energy = 0.0;   ///< J/mm³, of the mix of materials (CuttingCoefficients::Entry::tableEnergy)

    double forcePerFeed() const noexcept { return energy * area; } ///< J/mm: energy per millimetre of motion
};

} // namespace burin
