// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cutting/surface_flux.h"

namespace burin {

/// What the flutes stand in.
struct MetMaterial {
    Engagement engagement; ///< of the last tick that told it
    double area = 0.0;     ///< mm², that meets the material, across the motion, as it is felt (EngagedArea)
    double energy = 0.0;   ///< J/mm³, of the mix (CuttingCoefficients::Entry::tableEnergy)

    double forcePerFeed() const noexcept { return energy * area; } ///< J/mm: what a millimetre of way takes
};

} // namespace burin
