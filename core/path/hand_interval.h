// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/path.h"
#include "core/path/recording_edits.h"

#include <optional>
#include <vector>

namespace burin {

/// Whether a point has a moment of a source; points that an edit created have none.
bool hasMoment(const PathPoint& point) noexcept;

/// The moment of a point; source 0 if there is none.
Moment momentOf(const PathPoint& point) noexcept;

/// The moment on the move from one point to the next, at a fraction of its time, rounded to a tick; if the hand did not
/// lead the whole move, the moment of the nearer of the two points. @param share 0 … 1
Moment momentAt(const PathPoint& from, const PathPoint& to, double share) noexcept;

/// The edit that inserts a point at a fraction of the move from a point to the next, on the line. In a take, it names
/// the moment there; a planner's moments are points, so it names the one before and the distance from it.
/// @param piece index of the move's first point, one of the two has a moment; @param share 0 … 1
InsertPoint insertionAt(const std::vector<PathPoint>& points, std::size_t piece, double share);

/// Whether the move from one point to the next contains a moment of an interval. The start of the move does not count,
/// as it belongs to the move before. @param from, to moments of the points; source 0: none
bool leadsThrough(const Moment& from, const Moment& to, const SourceInterval& interval) noexcept;

/// Returns the points of a path with an additional point wherever a move passes an end of an interval, interpolated by
/// time between the points on either side. Rapids are not divided. Both parts of a divided arc keep its centre.
std::vector<PathPoint> dividedAt(const std::vector<PathPoint>& points, const SourceInterval& interval);

/// The parts of a path that were made in an interval of a source: chains of consecutive points, a single moment as a
/// chain of one. A moment whose own point an edit left out is interpolated on the move that passes it, by time between
/// the points on either side: within the deviation of that edit from the position of the hand at another time. Copies
/// made by an edit have chains of their own; an interval that is no longer in the path has none. Cost: linear.
std::vector<std::vector<PathPoint>> pointsOf(const Path& path, const SourceInterval& interval);

/// The first point that was made at a moment; empty if the path has none. As for `pointsOf`.
std::optional<PathPoint> pointAt(const Path& path, const Moment& moment);

/// The moment of the position on moves other than rapids that is nearest to a point; source 0 if an edit made it, or if
/// there is none. Arcs count as their chords in steps of 0.02 mm of deviation. Cost: linear. @param place mm
Moment momentNear(const Path& path, const glm::dvec3& place);

/// The position on the path at a moment, mm, setup frame. With the tip of the tool at that moment: the nearest position
/// on the move that was made then; without: that of `pointAt`, by time, which may be farther along a straight move than
/// the tool was. Empty if the path does not have the moment.
std::optional<glm::dvec3> placeAt(const Path& path, const Moment& moment, const std::optional<glm::dvec3>& tip);

} // namespace burin
