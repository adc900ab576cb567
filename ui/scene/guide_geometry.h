// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/box.h"

#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace burin {

// Where guides are to be seen, mm, setup frame. Any thread.

using Polygon = std::vector<glm::dvec3>;

/// What of a plane lies in a box: a convex polygon's three to six corners in order; empty: none. @param normal unit
Polygon planeInBox(const Box& box, const glm::dvec3& point, const glm::dvec3& normal);

/// The first and last of the planes point + level · distance · normal that meet a box; nothing: none does.
std::optional<std::pair<int, int>> levelsInBox(const Box& box, const glm::dvec3& point, const glm::dvec3& normal,
                                               double distance);

/// What of an endless line lies in a box; nothing: none. @param direction unit
std::optional<std::pair<glm::dvec3, glm::dvec3>> lineInBox(const Box& box, const glm::dvec3& point,
                                                           const glm::dvec3& direction);

/// The two curves at a distance from a pass on either side, seen along `direction` (unit), straight on beyond its ends,
/// at its height; in pieces where one runs into the pass again. The pass is taken within `passTolerance`, or, where it
/// has more corners than `passCorners`, evenly thinned to as many; corners are rounded by steps of 15°, so that a curve
/// lies within 1 % of the distance. Cost: square of the corners.
std::vector<Polygon> besidePass(std::span<const glm::dvec3> pass, const glm::dvec3& direction, double distance);
inline constexpr double passTolerance = 0.02; ///< mm
inline constexpr std::size_t passCorners = 600;

} // namespace burin
