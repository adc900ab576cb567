// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

namespace burin {

/// A stretch of a path, as its spindle sees it.
struct SpindleStretch {
    double fastest = 0.0; ///< 1/min that what it meets allows; infinite: it meets nothing
    double seconds = 0.0; ///< that it takes at the feed for that speed
    bool joined = false;  ///< it goes on where the one before it ended, without leaving the cut
};

/// When a spindle that takes its time changes its speed.
struct SpindleSpeeds {
    std::vector<double> told;   ///< 1/min by stretch, as the program says
    std::vector<double> sureOf; ///< 1/min by stretch, that the spindle has at least: what feeds may count on
};

/// Never faster than a stretch allows, and told so early that the spindle has come down by then; what is slower on the
/// way there is taken as if it lasted. A speed is raised only where it lasts for longer than the spindle needs for it;
/// until it is there, feeds count on the old one. Between cuts the spindle has all the time that it needs.
/// @param startTime s that a change of speed takes, at most; >= 0
SpindleSpeeds spindleSchedule(std::span<const SpindleStretch> stretches, double startTime);

/// 1/min by stretch, that a spindle which was told `told` has at least: `sureOf` of a schedule.
std::vector<double> sureSpeeds(std::span<const SpindleStretch> stretches, std::span<const double> told,
                               double startTime);

} // namespace burin
