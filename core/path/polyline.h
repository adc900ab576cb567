// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/segment.h"
#include "core/path/apply.h"

#include <functional>
#include <span>
#include <vector>

namespace burin {

/// Whether the tool may go straight from one tip to another; called only for moves that leave points out.
using ShortcutTest = std::function<bool(const glm::dvec3& from, const glm::dvec3& to)>;

/// Indices of the points that remain, in order, including first and last (Douglas & Peucker 1973, with the distance to
/// segments): every dropped point lies within `tolerance` of the segment that replaces it, hence the whole of one
/// polyline within `tolerance` of the other. Cost: n log n for ordinary paths, n² at worst.
std::vector<std::size_t> simplify(std::span<const StrokePoint> points, double tolerance, const ShortcutTest& allowed);

/// Points are simplified in groups of this size: bounds the cost, and lets threads share the work.
inline constexpr std::size_t simplifyGroup = 2000;

/// The same for a stroke of any length, group by group; cancellable.
std::vector<std::size_t> simplifyInGroups(std::span<const StrokePoint> points, double tolerance,
                                          const ShortcutTest& allowed, const Progress& progress);
/// The same for tips alone, mm, with any shortcut allowed.
std::vector<std::size_t> simplifyInGroups(std::span<const glm::dvec3> tips, double tolerance, const Progress& progress);

/// The largest distance of the points that are not in `kept` from the polyline of those that are.
/// @param kept ascending, with the first and the last index; empty only for no points
Deviation thinnedDeviation(std::span<const StrokePoint> points, std::span<const std::size_t> kept);

/// Drops the points that are not in `kept`; their flags are passed on to the next point that stays.
void keepOnly(std::vector<StrokePoint>& points, std::span<const std::size_t> kept);

} // namespace burin
