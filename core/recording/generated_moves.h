// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/base/setup_id.h"
#include "core/geometry/pose.h"

#include <cstdint>
#include <string>
#include <vector>

namespace burin {

/// A place that a planner, or a program, sends the tool to.
struct GeneratedPoint {
    ToolPose pose; ///< setup frame
    /// Names this place in edits, links and comments of programs, as a tick does in a take. A planner that is run again
    /// gives a place that means the same the same moment.
    std::int64_t moment = 0;
    bool removes = true;     ///< the motion that ends here is meant to take material away
    bool onBoundary = false; ///< the part is meant to hold the tool here
    /// What a program states of the motion that ends here; 0: nothing is stated, edits say it.
    double feed = 0.0;         ///< mm/min
    double spindleSpeed = 0.0; ///< 1/min
};

/// What holds for all of a planner's moves.
struct GeneratedInfo {
    std::int64_t id = 0;        ///< in its project, below 0: no take has such a number
    SetupId setup = setupInUse; ///< that they were made for
    std::string name;           ///< what the pass is, or the program's file
    std::string toolId;
    double allowance = 0.0; ///< mm that they leave on the part
    std::uint64_t pointCount = 0;
    std::string request{}; ///< what their planner was asked for (toJson of a PassRequest); empty: no planner made them
};

/// Moves that a planner made in place of a hand, or that a program of another system states: a source of paths, as a
/// take is. They have no time of their own: how fast the tool goes is the business of edits.
struct GeneratedMoves {
    GeneratedInfo info;
    /// Each without a gap, of at least one point; moments are at least 0, rise from one point to the next, and the
    /// moments of one stroke lie all before or all behind those of another.
    std::vector<std::vector<GeneratedPoint>> strokes;
};

/// mm; the most that a source of a path leaves on the part, as mill and the window take it.
inline constexpr double largestAllowance = 10.0;

/// Errors: argumentInvalid (an allowance that isn't within 0 … largestAllowance, no finite place or axis of unit
/// length, a feed or speed that is not finite or below 0, moments that don't rise, an empty stroke; place: the stroke
/// and point).
Result<void> checkGenerated(const GeneratedMoves& moves);

} // namespace burin
