// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/engagement_record.h"

namespace burin {

/// Moves with a feed for each stretch: a line is divided where its stretches ask for feeds that differ by too much, and
/// keeps the least of what one block's stretches ask for. An arc has one
/// feed and one speed.
/// @param record stretches of the points' moves, in order @param feeds mm/min, one a stretch
/// @param leastChange share by which feeds of one block may differ
/// @param speeds 1/min of the spindle, one a stretch, and of one block the same; empty: the moves keep theirs
std::vector<PathPoint> withFeeds(const std::vector<PathPoint>& points, const std::vector<MetStretch>& record,
                                 const std::vector<double>& feeds, double leastChange,
                                 const std::vector<double>& speeds = {});

/// An interval's volume is off by a layer of voxels, and what comes next may be harder: an interval comes down by as
/// much as its neighbours do. Only moves that cut; across rapids nothing is passed on.
std::vector<double> leastOfNeighbours(const std::vector<MetStretch>& record, const std::vector<PathPoint>& points,
                                      const std::vector<double>& feeds);

} // namespace burin
