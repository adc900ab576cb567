// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/engagement_record.h"

namespace burin {

/// The moves with a feed for each interval: a line is divided where the feeds of its intervals differ by too much; a
/// block gets the least feed of its intervals. An arc has one feed and one speed.
/// @param record intervals of the points' moves, in order @param feeds mm/min, one per interval
/// @param leastChange relative difference up to which feeds share a block
/// @param speeds 1/min of the spindle, one per interval, constant within a block; empty: the moves keep theirs
std::vector<PathPoint> withFeeds(const std::vector<PathPoint>& points, const std::vector<MetInterval>& record,
                                 const std::vector<double>& feeds, double leastChange,
                                 const std::vector<double>& speeds = {});

/// Reduces the feed of each interval by the same factor as that of its neighbours, if theirs is lower: the volume of an
/// interval is off by a layer of voxels, and the next material may be harder. Applies to cutting moves only; nothing is
/// passed on across rapids.
std::vector<double> leastOfNeighbours(const std::vector<MetInterval>& record, const std::vector<PathPoint>& points,
                                      const std::vector<double>& feeds);

} // namespace burin
