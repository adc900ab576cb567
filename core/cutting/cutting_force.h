// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cutting/removal.h"

#include <array>

namespace burin {

/// What the cutting force depends on besides the removed volume; copied out of the property list, so that the tick
/// reads plain arrays.
struct CuttingCoefficients {
    struct Entry {
        double specificEnergy = 0.0; ///< K, J/mm³
        double radialRatio = 0.0;    ///< Kr, 1
    };
    std::array<Entry, 256> byProperty{};
};
CuttingCoefficients cuttingCoefficients(const PropertyList& properties);

/// Force of one cut on the tool, N, setup frame, unscaled.
struct CuttingForce {
    double tangential = 0.0;  ///< N: sum over materials of 1000 K MRR / v (paper, eqs. 11, 12, 14)
    double radial = 0.0;      ///< N: sum of Kr Ft (eq. 13)
    double removalRate = 0.0; ///< mm³/s
    glm::dvec3 force{0.0};    ///< against the motion (tangential) and away from the removed material (radial)
};

/// @param cut          what the tick removed; its reported volumes drive the force
/// @param motion       of the tip in this tick, mm
/// @param tip          at the end of the tick, mm
/// @param cuttingSpeed of the flutes' edge, mm/s, > 0
/// @param period       of the tick, s, > 0
CuttingForce cuttingForce(const CutResult& cut, const CuttingCoefficients& coefficients, const glm::dvec3& motion,
                          const glm::dvec3& tip, double cuttingSpeed, double period) noexcept;

/// What a tool does in a material by the tables: the feed that the machine gets, whatever the hand's speed was.
struct CuttingConditions {
    double spindleSpeed = 0.0;     ///< 1/min
    double feed = 0.0;             ///< mm/min
    double plungeFeed = 0.0;       ///< mm/min
    double surfaceSpeed = 0.0;     ///< mm/s, that the spindle speed gives at the flutes
    bool limitedByMachine = false; ///< the table asked for more than tool or machine can do
};
/// n = vc / (pi D), feed = n z fz, both within the limits given; where the spindle is too slow, the feed follows the
/// speed that it reaches.
/// @param maximumSpindleSpeed of the machine, 1/min; the tool's own limit counts too
/// @param maximumFeed         of the machine, mm/min
/// Errors: resourceInvalid (subject: material, place: the value that it lacks), argumentInvalid (a limit not above 0).
Result<CuttingConditions> cuttingConditions(const Tool& tool, const Property& material, double maximumSpindleSpeed,
                                            double maximumFeed);

} // namespace burin
