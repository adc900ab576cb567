// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/stroke.h"

#include <functional>
#include <optional>
#include <vector>

namespace burin {

/// A point that is being kept out of the part.
struct Held {
    StrokePoint point;
    glm::dvec3 origin{0.0}; ///< position of the path before the edit, mm
};

/// Consecutive held points with clear motions between them.
struct HeldRun {
    std::vector<Held> points;
    std::vector<Held> before, behind; ///< of the path before its first point, or behind its last one: lost at a break
};

/// mm, of the path before the edit.
double originLength(const HeldRun& run);

/// At a break, a point farther from the path than this no longer belongs to it, mm; earlier edits and the hand's tremor
/// have moved it by less.
inline constexpr double farthestAside = 0.25;

/// The tip kept out of the part that corresponds to a point of the path; empty if it is not near, or if no clear move
/// leads there. @param along unit, direction of the path
using FollowPath =
    std::function<std::optional<glm::dvec3>(const glm::dvec3& from, const glm::dvec3& place, const glm::dvec3& along)>;

/// Resolves breaks: places between two runs where no clear motion leads. Points pushed out there move back along the
/// path, or aside, and pile up: each run keeps the points that are on the path and farther along it than the points
/// before, then continues along the path as far as it can be followed. A run without remaining points is dropped, and
/// its part of the path is lost with the break.
/// @param runs of one stroke, in order, none without points
void settleBreaks(std::vector<HeldRun>& runs, const FollowPath& follow);

} // namespace burin
