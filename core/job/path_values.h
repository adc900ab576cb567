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

/// What a path can be coloured by.
enum class PathQuantity { feed, spindleSpeed, height, removalRate, force, deviation };
inline constexpr std::array pathQuantities{PathQuantity::feed,   PathQuantity::spindleSpeed,
                                           PathQuantity::height, PathQuantity::removalRate,
                                           PathQuantity::force,  PathQuantity::deviation};

/// Stable, of command lines and settings: "feed", "spindle-speed", "removal-rate".
std::string_view idOf(PathQuantity quantity) noexcept;
std::optional<PathQuantity> pathQuantityFromId(std::string_view id) noexcept;
/// "Feed", to be translated.
TextId titleOf(PathQuantity quantity) noexcept;
/// Of its values: "mm/min".
std::string_view unitOf(PathQuantity quantity) noexcept;

/// A straight piece of a move at feed.
struct ValuedPiece {
    glm::dvec3 from{0.0}, to{0.0}; ///< mm, setup frame
    std::optional<double> value{}; ///< nothing: there is none, as for the deviation of what an edit made
};

/// A quantity along a path. Rapids have no piece.
struct PathValues {
    PathQuantity quantity = PathQuantity::feed;
    std::vector<ValuedPiece> pieces; ///< in the path's order
    double low = 0.0, high = 0.0;    ///< of the values; 0 where there is none
};

/// Feed in mm/min, spindle speed in 1/min, height of the tip in mm above the program's zero (of a piece: its middle),
/// removal rate in mm³/s, tangential cutting force in N, deviation in mm: how far the path is from where the hand, a
/// planner or a program went between the same moments, at most. Removal and force are those of intervals of 0.5 mm,
/// cut out of the stock that the paths before leave. Any thread. Cost: for removal and force the path is cut once.
/// @param milling its tool does not count @param before what is milled before the path, in order
/// @param sources the path's own, for the deviation alone; else they may be empty
/// Errors: those of MilledStock::lend and recordEngagement; cancelled.
Result<PathValues> pathValues(PathQuantity quantity, const MilledPath& path, std::span<const MilledPath> before,
                              std::span<const SourceStrokes> sources, const MillingContext& milling,
                              Progress& progress);

} // namespace burin
