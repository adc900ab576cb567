// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/passes/intent_motion.h"
#include "core/passes/workpiece_heights.h"

#include <vector>

namespace burin {

/// Speeds of a hand, mm/s, setup frame.
struct HandSpeeds {
    double cutting = 100.0;
    double plunging = 30.0;    ///< down into stock
    double travelling = 250.0; ///< in the air
};
/// The fastest speeds that an operator is asked for when time is short: brisk sanding strokes. Our estimate.
inline constexpr HandSpeeds fastestHand{250.0, 50.0, 400.0};

/// Height of the tip above the stock while it travels.
inline constexpr double travelHeight = 3.0; // mm

/// Roughing in levels. Lengths in mm, setup frame.
struct RoughingRequest {
    double bottom = 0.0;     ///< height of the last level: the part's lowest point
    double allowance = 0.5;  ///< stock left on the part
    double stepOver = 0.0;   ///< between rows; 0: 0.75 of the diameter
    double levelDepth = 0.0; ///< 0: 1.25 of the diameter; always reduced to what the tool can cut
    /// Height of stock that the finishing passes may remove at once: roughing leaves out points at which no more stock
    /// than this is left above the part. 0: leaves out none. Ignored where it is less than the distance between levels.
    double finishingDepth = 0.0;
    /// Leaves stock that is well away from the part of the model above the bottom; for milling only an upper part.
    bool nearPartOnly = false;
    bool restOnly = false; ///< only rows where stock is left, because other tools have milled before
    HandSpeeds speeds;
};

struct RoughingPlan {
    std::vector<IntentPoint> points; ///< begins and ends above the stock; empty if there is nothing to rough
    std::vector<double> levels;      ///< heights, falling; the last is the bottom
};

/// Plans levels from the top of the stock to the bottom, in zigzag rows along x. The rows cover the stock and extend a
/// radius beyond it, so that the cutter enters from the side. They end at the part plus its allowance. Neighbouring
/// pieces are joined within the level where part and shank allow it; otherwise the tool retracts and comes down where
/// the level above is cleared.
/// @param field clearance of this tool from the part @param heights the stock; updated to what the plan leaves
/// Errors: argumentInvalid.
Result<RoughingPlan> planRoughing(const ClearanceField& field, const Tool& tool, const RoughingRequest& request,
                                  WorkpieceHeights& heights);

/// Finishing in parallel passes. Lengths in mm, setup frame.
struct FinishingRequest {
    Box part;                       ///< the part's bounding box
    double floor = 0.0;             ///< lower limit of the passes: the lowest point of the part
    double stepOver = 0.0;          ///< between rows; 0: a fifteenth of the diameter
    double crosswiseStepOver = 0.0; ///< between crosswise passes; 0: 1.5 times that of the rows
    double press = 2.0;             ///< how far below the surface of the part the hand aims
    double floorMargin = 1.5;       ///< how far a pass extends beyond the part
    bool restOnly = false;          ///< only passes where stock is left, because other tools have milled before
    double deepest = 0.0;           ///< height of standing stock that a pass removes at once; 0: no limit
    double deepestBelow = 0.0;      ///< depth of stock below its middle that a tool plunges into at once; 0: no limit
    HandSpeeds speeds;
};

/// Plans zigzag passes along x over the part and a radius beyond it. The hand aims `press` below the height at which
/// the part stops the tool, never below the floor, and never so deep that shank or holder would touch the stock that
/// still stands around the tool. Where more stock stands than a pass may remove at once, the hand repeats the pass to
/// and fro, deeper each time, and enters along a ramp. Parameters and errors as planRoughing.
Result<std::vector<IntentPoint>> planFinishing(const ClearanceField& field, const Tool& tool,
                                               const FinishingRequest& request, WorkpieceHeights& heights);

/// Plans zigzag passes along y where the part is steeper than 45 degrees across the rows of planFinishing, which touch
/// such a wall only here and there. The hand follows the wall between its foot and its rim, presses at right angles to
/// it, and never goes below the floor or to where shank or holder would touch standing stock. Between neighbouring
/// passes that cannot be joined it retracts. Parameters and errors as planRoughing. @return empty if no face is that
/// steep
Result<std::vector<IntentPoint>> planCrosswiseFinishing(const ClearanceField& field, const Tool& tool,
                                                        const FinishingRequest& request, WorkpieceHeights& heights);

/// The duration of the motion along an intent, s, without the time to settle; 0 for an invalid intent.
/// @param limits in the frame of the points, see inSetup
double estimateSeconds(std::span<const IntentPoint> points, const MotionLimits& limits);

/// Converts the limits of a hand, which are given in the device frame, to the setup frame through the scale of a
/// mapping.
MotionLimits inSetup(MotionLimits device, double scale);

/// A complete session.
struct MillingRequest {
    Box stock; ///< mm
    RoughingRequest roughing;
    FinishingRequest finishing;
    MotionLimits motion;    ///< setup frame
    double timeLimit = 0.0; ///< s for roughing and finishing together; 0: none
    bool crosswise = true;  ///< also finish steep faces crosswise; not if only remaining stock is milled
    StandingStock standing; ///< what earlier takes have left: only that is milled; empty: the whole box stands
};

struct MillingPlan {
    std::vector<IntentPoint> roughing;
    std::vector<IntentPoint> finishing; ///< rows, then crosswise
    std::vector<double> levels;         ///< heights of the roughing levels
    double roughingSeconds = 0.0;
    double finishingSeconds = 0.0;
    double speedFactor = 1.0;       ///< largest factor by which the requested speeds were raised
    double finishingStepOver = 0.0; ///< mm, as planned
    double bottom = 0.0;            ///< mm: height below which nothing is milled
    bool truncated = false;         ///< the lower part, or the end, was left out because the time limit is too short
};

/// Whether passes can be planned for a tool: the passes move it down and sideways, and the stock is seen from above.
/// Errors: notSupported (a drill, which cuts only downwards; a cutter that is wider below than above, such as a
/// lollipop or T-slot cutter).
Result<void> checkPlannable(const Tool& tool);

/// Plans roughing and finishing. If the time limit is exceeded, it first raises the speeds up to `fastestHand`, then
/// increases the step-over of finishing by up to a quarter, then omits the crosswise passes. If the time is still too
/// short, it mills only the upper part, down to the lowest height at which everything that is roughed is finished too;
/// as a last resort it omits the end. Errors: argumentInvalid, those of checkPlannable.
Result<MillingPlan> planMilling(const ClearanceField& field, const Tool& tool, const MillingRequest& request);

} // namespace burin
