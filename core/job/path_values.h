// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/text.h"
#include "core/job/milled_stock.h"
#include "core/job/milling_context.h"
#include "core/path/stroke.h"

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace burin {

/// A quantity that a path can be coloured by.
enum class PathQuantity { feed, spindleSpeed, height, removalRate, force, deviation };
inline constexpr std::array pathQuantities{PathQuantity::feed,   PathQuantity::spindleSpeed,
                                           PathQuantity::height, PathQuantity::removalRate,
                                           PathQuantity::force,  PathQuantity::deviation};

/// Stable id, for command lines and settings: "feed", "spindle-speed", "removal-rate".
std::string_view idOf(PathQuantity quantity) noexcept;
std::optional<PathQuantity> pathQuantityFromId(std::string_view id) noexcept;
/// Returns the title, to be translated: "Feed".
TextId titleOf(PathQuantity quantity) noexcept;
/// Returns the unit of the values: "mm/min".
std::string_view unitOf(PathQuantity quantity) noexcept;

/// A straight piece of a feed move.
struct ValuedPiece {
    glm::dvec3 from{0.0}, to{0.0}; ///< mm, setup frame
    std::optional<double> value{}; ///< empty: no value, such as the deviation of a move made by an edit
};

/// A quantity along a path. Rapids have no pieces.
struct PathValues {
    PathQuantity quantity = PathQuantity::feed;
    std::vector<ValuedPiece> pieces; ///< in the path's order
    double low = 0.0, high = 0.0;    ///< of the values; 0 if there are none
};

/// Returns a quantity along a path: feed in mm/min, spindle speed in 1/min, height of the tip in mm above the program's
/// zero (at the middle of a piece), removal rate in mm³/s, tangential cutting force in N, deviation in mm: the largest
/// distance of the path from the motion of the hand, planner or program between the same moments. Removal and force are
/// determined in intervals of 0.5 mm, cut out of the stock left by the preceding paths. Thread-safe. Cost: for removal
/// and force the path is cut once.
/// @param milling its tool is ignored @param before the paths milled before the path, in order
/// @param sources of the path, only for the deviation; otherwise they may be empty
/// Errors: those of MilledStock::lend and recordEngagement; cancelled.
Result<PathValues> pathValues(PathQuantity quantity, const MilledPath& path, std::span<const MilledPath> before,
                              std::span<const SourceStrokes> sources, const MillingContext& milling,
                              Progress& progress);

} // namespace burin
