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
/// As fast as an operator is asked to work when the time is short: brisk sanding strokes. Our estimate.
inline constexpr HandSpeeds fastestHand{250.0, 50.0, 400.0};

/// How far above the stock the tip travels.
inline constexpr double travelHeight = 3.0; // mm

/// Roughing in levels. Lengths in mm, setup frame.
struct RoughingRequest {
    double bottom = 0.0;     ///< height of the last level: the part's lowest point
    double allowance = 0.5;  ///< left on the part
    double stepOver = 0.0;   ///< between rows; 0: 0.75 of the diameter
    double levelDepth = 0.0; ///< 0: 1.25 of the diameter; always cut down to what the tool can
    /// Stock that the finishing passes may take at once: roughing keeps out of places where no more is left above the
    /// part. 0: no such place. Ignored below the distance of the levels.
    double finishingDepth = 0.0;
    /// Leave stock that stands well beside what of the part rises above the bottom: for milling an upper part alone.
    bool nearPartOnly = false;
    bool restOnly = false; ///< rows only where stock is left: other tools have milled before
    HandSpeeds speeds;
};

struct RoughingPlan {
    std::vector<IntentPoint> points; ///< begins and ends above the stock; empty: nothing to rough
    std::vector<double> levels;      ///< heights, falling; the last is the bottom
};

/// Levels from the top of the stock to the bottom, in zig-zag rows along x over the stock and a radius beyond, so that
/// the cutter enters from the side. Rows end where the part with its allowance begins. Neighbouring pieces are joined
/// within the level where part and shank allow it; else the tool lifts and comes down where the level above is cleared.
/// @param field clearance of this tool from the part. @param heights the stock; afterwards as the plan leaves it.
/// Errors: argumentInvalid.
Result<RoughingPlan> planRoughing(const ClearanceField& field, const Tool& tool, const RoughingRequest& request,
                                  WorkpieceHeights& heights);

/// Finishing in parallel passes. Lengths in mm, setup frame.
struct FinishingRequest {
    Box part;                       ///< the part's bounding box
    double floor = 0.0;             ///< the passes don't go below: the part's lowest point
    double stepOver = 0.0;          ///< between rows; 0: a fifteenth of the diameter
    double crosswiseStepOver = 0.0; ///< between crosswise passes; 0: 1.5 times that of the rows
    double press = 2.0;             ///< how far below the part's surface the hand aims
    double floorMargin = 1.5;       ///< how far a pass runs on beside the part
    bool restOnly = false;          ///< passes only where stock is left: other tools have milled before
    double deepest = 0.0;           ///< of standing stock that a pass takes at once; 0: as much as there is
    double deepestBelow = 0.0;      ///< of stock below its middle that a tool sinks into at once; 0: any
    HandSpeeds speeds;
};

/// Zig-zag passes along x over the part and a radius beyond. The hand aims `press` below where the part stops the tool,
/// never below the floor, and never so deep that shank or holder reach the stock that still stands around the tool.
/// Where more stock stands than it takes at once, it goes to and fro over the pass, deeper each time, and down a ramp.
/// Parameters and errors as planRoughing.
Result<std::vector<IntentPoint>> planFinishing(const ClearanceField& field, const Tool& tool,
                                               const FinishingRequest& request, WorkpieceHeights& heights);

/// Zig-zag passes along y where the part is steeper than 45 degrees across the rows of planFinishing: these touch a
/// wall only here and there. The hand follows the wall between its foot and its rim, presses square to it, and never
/// goes below the floor or where shank or holder would reach standing stock. Where neighbouring passes don't join, it
/// lifts. Parameters and errors as planRoughing. @return empty: no such place
Result<std::vector<IntentPoint>> planCrosswiseFinishing(const ClearanceField& field, const Tool& tool,
                                                        const FinishingRequest& request, WorkpieceHeights& heights);

/// What the motion along an intent takes, s, without the time to settle; 0 for an invalid one.
/// @param limits in the frame of the points: see inSetup.
double estimateSeconds(std::span<const IntentPoint> points, const MotionLimits& limits);

/// A hand's limits, which hold in the device frame, as they appear through a mapping's scale.
MotionLimits inSetup(MotionLimits device, double scale);

/// A whole session.
struct MillingRequest {
    Box stock; ///< mm
    RoughingRequest roughing;
    FinishingRequest finishing;
    MotionLimits motion;    ///< setup frame
    double timeLimit = 0.0; ///< s for both together; 0: none
    bool crosswise = true;  ///< finish steep places crosswise too, but where only the rest is milled
    StandingStock standing; ///< what earlier takes have left: then only that is milled; none: the whole box stands
};

struct MillingPlan {
    std::vector<IntentPoint> roughing;
    std::vector<IntentPoint> finishing; ///< rows, then crosswise
    std::vector<double> levels;         ///< heights of the roughing levels
    double roughingSeconds = 0.0;
    double finishingSeconds = 0.0;
    double speedFactor = 1.0;       ///< by which the asked speeds were raised at most
    double finishingStepOver = 0.0; ///< mm, as planned
    double bottom = 0.0;            ///< mm: height below which nothing is milled
    bool truncated = false;         ///< the lower part, or the end, was left out: the limit is too short
};

/// Whether passes can be planned for a tool: they are led down and sideways, and seen from above. Errors: notSupported
/// (a drill, which cuts downwards alone; a cutter that is wider below than above: lollipop, T-slot).
Result<void> checkPlannable(const Tool& tool);

/// Plans both. Where the time limit is shorter, raises the speeds up to `fastestHand`, then widens the finishing passes
/// by up to a quarter, then leaves out the crosswise passes. Is it still too short, mills only the upper part, down to
/// the lowest height at which what is roughed is finished too; at last leaves out the end. Errors: argumentInvalid,
/// those of checkPlannable.
Result<MillingPlan> planMilling(const ClearanceField& field, const Tool& tool, const MillingRequest& request);

} // namespace burin
