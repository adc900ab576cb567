// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace burin {

/// Constraint of a stroke, seen along the tool axis.
enum class StrokeLock : std::uint8_t {
    none,
    alongX,   ///< only X changes, setup frame
    alongY,   ///< only Y changes
    direction ///< straight, in the direction that it had when locked
};

/// Rows that fill a rectangle along its longer side, back and forth: the first and the last are on its edges, the
/// others evenly between them, at most `stepOver` apart.
/// @param corner start of the first row, mm, setup frame; @param opposite the opposite corner; its z is ignored
/// @param stepOver mm, > 0 @return the ends of the rows in the order of milling, all at corner.z
std::vector<glm::dvec3> rasterRows(const glm::dvec3& corner, const glm::dvec3& opposite, double stepOver);

/// A line with additional points, so that consecutive points are at most `spacing` apart (mm, > 0). Its own points are
/// kept.
std::vector<glm::dvec3> subdivided(const std::vector<glm::dvec3>& line, double spacing);

/// The tool axes at the points that `subdivided` returns, unit: interpolated between those at the line's own points.
/// @param axes unit, one for each point of the line
std::vector<glm::dvec3> subdividedAxes(const std::vector<glm::dvec3>& line, const std::vector<glm::dvec3>& axes,
                                       double spacing);

/// The number of points that `subdivided` would return.
double subdividedCount(const std::vector<glm::dvec3>& line, double spacing);

/// Unit vector, z = 0, to the left of a line in its direction, seen from above: perpendicular to the vector from its
/// first point to the point farthest from it. Empty: the line has no extent in x and y.
std::optional<glm::dvec3> acrossOf(const std::vector<glm::dvec3>& line);

/// The direction of a line at its end: unit, z = 0, over the last `length` mm of it. Empty: it is shorter.
std::optional<glm::dvec3> directionAtEnd(const std::vector<glm::dvec3>& line, double length);

/// The nearest point to `place` that a lock allows, starting from `anchor`; z is kept.
/// @param direction unit, z = 0; of StrokeLock::direction
glm::dvec3 locked(StrokeLock lock, const glm::dvec3& anchor, const glm::dvec3& direction, const glm::dvec3& place);

} // namespace burin
