// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/passes/milling_plan.h"

#include <cstdint>

namespace burin {

/// The intent of a virtual operator.
enum class OperatorIntent : std::uint8_t {
    passes,   ///< roughing in levels, finishing in parallel passes: planMilling
    contour,  ///< around the part, level by level: planContours
    scribble, ///< aimless hand motion: planScribble
    hostile,  ///< HostileStylus
};

/// Contour following. Lengths in mm, setup frame.
struct ContourRequest {
    Box stock;
    double bottom = 0.0;     ///< height of the last level
    double allowance = 0.0;  ///< stock to leave on the part
    double levelDepth = 0.0; ///< between levels; 0: half of the diameter
    double press = 1.0;      ///< how far into the part the hand aims, at right angles to it
    HandSpeeds speeds;
};

/// Follows the outline of the part at each level from the top of the stock to the bottom, as far down as the flutes
/// reach. The outline is the one met first from +x; it is followed once around, with the part to the left of the hand.
/// A level is left out if no outline is met there or the outline cannot be followed all the way. The points of an
/// outline are within a hundredth of a millimetre of it; the distance between them is a quarter of the radius, at most
/// a millimetre. Errors: argumentInvalid, those of checkPlannable.
Result<std::vector<IntentPoint>> planContours(const ClearanceField& field, const Tool& tool,
                                              const ContourRequest& request);

/// Aimless motion of a hand. Lengths in mm, setup frame.
struct ScribbleRequest {
    Box region;            ///< the region in which the tip is meant to stay
    double seconds = 20.0; ///< at most one day
    double speed = 80.0;   ///< mm/s, approximate mean
    std::uint64_t seed = 1;
};

/// A smooth, aimless path through a region: along each axis a sum of sines with periods of 0.8 s or more, because most
/// of a hand's voluntary motion is slower than 2 Hz. The same seed gives the same path. Errors: argumentInvalid.
Result<std::vector<IntentPoint>> planScribble(const ScribbleRequest& request);

} // namespace burin
