// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/passes/milling_plan.h"

#include <cstdint>

namespace burin {

/// What a virtual operator is after.
enum class OperatorIntent : std::uint8_t {
    passes,   ///< roughing in levels, finishing in parallel passes: planMilling
    contour,  ///< round the part, level by level: planContours
    scribble, ///< wherever the hand likes: planScribble
    hostile,  ///< HostileStylus
};

/// Contour following. Lengths in mm, setup frame.
struct ContourRequest {
    Box stock;
    double bottom = 0.0;     ///< height of the last level
    double allowance = 0.0;  ///< that the part will be grown by
    double levelDepth = 0.0; ///< between levels; 0: half of the diameter
    double press = 1.0;      ///< how far into the part the hand aims, square to it
    HandSpeeds speeds;
};

/// Follows the part's outline at each level from the top of the stock to the bottom, as far down as the flutes reach:
/// the one that is met first from +x, once round, with the part to the hand's left. A level at which none is met, or
/// whose outline can't be followed round, is left out. The points of an outline lie within a hundredth of a millimetre
/// of it and a quarter of the radius, or a millimetre, apart. Errors: argumentInvalid, those of checkPlannable.
Result<std::vector<IntentPoint>> planContours(const ClearanceField& field, const Tool& tool,
                                              const ContourRequest& request);

/// A free hand. Lengths in mm, setup frame.
struct ScribbleRequest {
    Box region;            ///< that the tip is meant to stay in
    double seconds = 20.0; ///< at most a day
    double speed = 80.0;   ///< mm/s, on average about
    std::uint64_t seed = 1;
};

/// A smooth way without an aim through a region: along each axis a sum of sines with periods from 0.8 s on, as most of
/// a hand's voluntary motion is slower than 2 Hz. The same seed gives the same way. Errors: argumentInvalid.
Result<std::vector<IntentPoint>> planScribble(const ScribbleRequest& request);

} // namespace burin
