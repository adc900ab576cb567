// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/coolant.h"
#include "core/base/result.h"
#include "core/base/setup_id.h"
#include "core/geometry/pose.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace burin {

/// A point that a planner, or a program, sends the tool to.
struct GeneratedPoint {
    ToolPose pose; ///< setup frame
    /// Identifies this point in edits, links and comments of programs, as a tick does in a take. When a planner is run
    /// again, a point with the same meaning gets the same moment.
    std::int64_t moment = 0;
    bool removes = true;     ///< the motion that ends here is meant to remove material
    bool onBoundary = false; ///< the part is meant to limit the tool here
    /// Values that a program states for the motion that ends here; 0 or empty: not stated, edits determine them.
    double feed = 0.0;         ///< mm/min
    double spindleSpeed = 0.0; ///< 1/min
    std::optional<Coolant> coolant{};
};

/// Properties common to all of a planner's moves.
struct GeneratedInfo {
    std::int64_t id = 0;        ///< in its project, below 0: no take has such an id
    SetupId setup = setupInUse; ///< the setup that they were made for
    std::string name;           ///< kind of pass, or the program's file
    std::string toolId;
    double allowance = 0.0; ///< mm of stock that they leave on the part
    std::uint64_t pointCount = 0;
    std::string request{}; ///< request to their planner (toJson of a PassRequest); empty: not made by a planner
};

/// Moves that were made by a planner instead of a hand, or that a program of another system contains: a source of
/// paths, as a take is. They have no time of their own: the speed of the tool is determined by edits.
struct GeneratedMoves {
    GeneratedInfo info;
    /// Each continuous and of at least one point; moments are at least 0 and rise from one point to the next, and all
    /// moments of one stroke lie either before or behind those of another.
    std::vector<std::vector<GeneratedPoint>> strokes;
};

/// Largest allowance of a source of a path, mm, as accepted by mill and the window.
inline constexpr double largestAllowance = 10.0;

/// Errors: argumentInvalid (an allowance outside 0 … largestAllowance, a position that is not finite or an axis that is
/// not of unit length, a feed or speed that is not finite or below 0, moments that do not rise, an empty stroke; place:
/// the stroke and point).
Result<void> checkGenerated(const GeneratedMoves& moves);

} // namespace burin
