// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/box.h"

#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace burin {

// The visible geometry of guides, mm, setup frame. Any thread.

using Polygon = std::vector<glm::dvec3>;

/// The intersection of a plane with a box: the three to six corners of a convex polygon, in order; empty if there is
/// none. @param normal unit
Polygon planeInBox(const Box& box, const glm::dvec3& point, const glm::dvec3& normal);

/// The first and last of the planes point + level · distance · normal that intersect a box; std::nullopt if none does.
std::optional<std::pair<int, int>> levelsInBox(const Box& box, const glm::dvec3& point, const glm::dvec3& normal,
                                               double distance);

/// The part of an infinite line within a box; std::nullopt if there is none. @param direction unit
std::optional<std::pair<glm::dvec3, glm::dvec3>> lineInBox(const Box& box, const glm::dvec3& point,
                                                           const glm::dvec3& direction);

/// The two offset curves at a distance on either side of a pass, seen along `direction` (unit), extended straight
/// beyond its ends, at its height; in pieces where a curve would come too close to another part of the pass. The pass
/// is simplified within `passTolerance` or, if it then has more than `passCorners` corners, evenly thinned to that
/// number; corners are rounded in steps of 15°, so that a curve is accurate to 1 % of the distance. Cost: quadratic in
/// the number of corners.
std::vector<Polygon> besidePass(std::span<const glm::dvec3> pass, const glm::dvec3& direction, double distance);
inline constexpr double passTolerance = 0.02; ///< mm
inline constexpr std::size_t passCorners = 600;

} // namespace burin
