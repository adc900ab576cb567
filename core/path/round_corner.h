// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <vector>

namespace burin {

/// Points of the arc that touches both legs of a corner at the distance `leg` from it, mm, in chords of 0.02 mm or 64
/// per arc; only the corner if it is straight, folded back, or has no leg.
/// @param back @param on directions from the corner along its legs, of any length
std::vector<glm::dvec3> cornerArc(const glm::dvec3& corner, const glm::dvec3& back, const glm::dvec3& on, double leg);

/// Quarter of a circle upwards from a tip, in a horizontal unit direction, in eight chords.
std::vector<glm::dvec3> quarterUp(const glm::dvec3& tip, const glm::dvec3& along, double radius);

} // namespace burin
