// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

namespace burin {

/// An interval of a path, as far as it concerns the spindle.
struct SpindleInterval {
    double fastest = 0.0; ///< 1/min allowed by the material that it meets; infinite: it meets none
    double seconds = 0.0; ///< duration at the feed for that speed
    bool joined = false;  ///< it continues from the end of the interval before, without leaving the cut
};

/// Programmed and guaranteed speeds of a spindle that takes time to change its speed.
struct SpindleSpeeds {
    std::vector<double> told;   ///< 1/min per interval, as programmed
    std::vector<double> sureOf; ///< 1/min per interval, guaranteed lower bound of the actual speed: feeds rely on it
};

/// Speeds are never faster than an interval allows, and are commanded early enough that the spindle has slowed down by
/// then; a short interval of lower speed on the way is treated as if it lasted. A speed is raised only where it lasts
/// for longer than the spindle needs for the change; until it is reached, feeds rely on the old one. Between cuts the
/// spindle has all the time that it needs.
/// @param startTime s, longest duration of a change of speed; >= 0
SpindleSpeeds spindleSchedule(std::span<const SpindleInterval> intervals, double startTime);

/// Guaranteed lower bound of the actual speed in each interval for the programmed speeds `told`, 1/min: `sureOf` of a
/// schedule.
std::vector<double> sureSpeeds(std::span<const SpindleInterval> intervals, std::span<const double> told,
                               double startTime);

} // namespace burin
