// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/stroke.h"

#include <functional>
#include <optional>
#include <vector>

namespace burin {

/// A point on its way out of the part.
struct Held {
    StrokePoint point;
    glm::dvec3 origin{0.0}; ///< where the path was before, mm
};

/// Held points that clear motions lead through.
struct HeldRun {
    std::vector<Held> points;
    std::vector<Held> before, behind; ///< of the path before its first point, or behind its last one: lost at a break
};

/// mm, of the path before.
double originLength(const HeldRun& run);

/// At a break a point farther from the path than this is no part of it any more, mm: earlier edits and the hand's
/// tremor have moved it by less.
inline constexpr double farthestAside = 0.25;

/// The tip that is held out beside a place of the path; nothing where it is not near, or no clear move leads there.
/// @param along unit, of the path
using FollowPath =
    std::function<std::optional<glm::dvec3>(const glm::dvec3& from, const glm::dvec3& place, const glm::dvec3& along)>;

/// Between two runs no clear motion leads. What was pushed out there goes back along the path, or aside, and piles up:
/// each run keeps what is on the path and farther along it than the points before, then goes on along the path as far
/// as it can be followed. A run of which nothing is left goes; what it was is lost with the break.
/// @param runs of one stroke, in order, none without points
void settleBreaks(std::vector<HeldRun>& runs, const FollowPath& follow);

} // namespace burin
