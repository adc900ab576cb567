// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace burin {

/// What a stroke keeps to, seen along the tool's axis.
enum class StrokeLock : std::uint8_t {
    none,
    alongX,   ///< only X changes, setup frame
    alongY,   ///< only Y changes
    direction ///< straight on, as it was going when it was locked
};

/// Rows that fill a rectangle along its longer side, there and back: first and last lie on its edges, those between
/// them evenly, at most `stepOver` apart.
/// @param corner where the first row begins, mm, setup frame; @param opposite the corner across; its z is not read
/// @param stepOver mm, > 0 @return the ends of the rows in the order in which they are milled, all at corner.z
std::vector<glm::dvec3> rasterRows(const glm::dvec3& corner, const glm::dvec3& opposite, double stepOver);

/// A line with more places, so that none is farther from the next than `spacing` (mm, > 0). Its own stay.
std::vector<glm::dvec3> subdivided(const std::vector<glm::dvec3>& line, double spacing);

/// How many places `subdivided` would give.
double subdividedCount(const std::vector<glm::dvec3>& line, double spacing);

/// Unit, z = 0, across a line to its left as it goes, seen from above: square to the way from its first place to that
/// which is farthest from it. Nothing: the line has no extent in x and y.
std::optional<glm::dvec3> acrossOf(const std::vector<glm::dvec3>& line);

/// In which a line goes at its end: unit, z = 0, over the last `length` mm of it. Nothing: it isn't that long.
std::optional<glm::dvec3> directionAtEnd(const std::vector<glm::dvec3>& line, double length);

/// The place nearest to `place` that a lock allows from `anchor` on; z stays.
/// @param direction unit, z = 0; of StrokeLock::direction
glm::dvec3 locked(StrokeLock lock, const glm::dvec3& anchor, const glm::dvec3& direction, const glm::dvec3& place);

} // namespace burin
