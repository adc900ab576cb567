// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/edit_values.h"
#include "core/path/path.h"

#include <vector>

namespace burin {

/// Whether a point has a moment of a source; points that an edit created have none.
bool hasMoment(const PathPoint& point) noexcept;

/// The moment of a point; source 0 if there is none.
Moment momentOf(const PathPoint& point) noexcept;

/// The moment on the move from one point to the next, at a fraction of its time, rounded to a tick; if the hand did not
/// lead the whole move, the moment of the nearer of the two points. @param share 0 … 1
Moment momentAt(const PathPoint& from, const PathPoint& to, double share) noexcept;

/// Whether the move from one point to the next contains a moment of an interval. The start of the move does not count,
/// as it belongs to the move before. @param from, to moments of the points; source 0: none
bool leadsThrough(const Moment& from, const Moment& to, const SourceStretch& stretch) noexcept;

/// Returns the points of a path with an additional point wherever a move passes an end of an interval, interpolated by
/// time between the points on either side. Rapids are not divided. Both parts of a divided arc keep its centre.
std::vector<PathPoint> dividedAt(const std::vector<PathPoint>& points, const SourceStretch& stretch);

/// The parts of a path that were made in an interval of a source: chains of consecutive points, a single moment as a
/// chain of one. A moment whose own point an edit left out is interpolated on the move that passes it, by time between
/// the points on either side: within the deviation of that edit from the position of the hand at another time. Copies
/// made by an edit have chains of their own; an interval that is no longer in the path has none. Cost: linear.
std::vector<std::vector<PathPoint>> pointsOf(const Path& path, const SourceStretch& stretch);

} // namespace burin
