// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <vector>

namespace burin {

/// Corners of a polygon in plan view, mm, closed implicitly.
using PlanRing = std::vector<glm::dvec2>;

/// A region in plan view, mm: the points inside an odd number of its rings. Any number of threads may read one.
struct PlanRegion {
    std::vector<PlanRing> rings;

    bool empty() const noexcept { return rings.empty(); }
    friend bool operator==(const PlanRegion&, const PlanRegion&) = default;
};

/// One connected piece of a region.
struct PlanPiece {
    PlanRing border;             ///< anticlockwise
    std::vector<PlanRing> holes; ///< each clockwise
};

/// An axis-parallel rectangle.
struct PlanBounds {
    glm::dvec2 low{0.0}, high{0.0}; ///< mm
};

/// The farthest coordinate that the functions below accept, mm from the origin along each axis; they work on a grid of
/// 1e-4 mm.
inline constexpr double farthestInPlan = 1e5;

PlanRegion rectangle(const glm::dvec2& low, const glm::dvec2& high);
/// All 0 for an empty region.
PlanBounds boundsOf(const PlanRegion& region) noexcept;
bool holds(const PlanRegion& region, const glm::dvec2& place) noexcept;

/// The points within `distance` of a region; for a negative distance the points of the region farther than that from
/// its border.
/// @param tolerance  mm: round corners are approximated by chords within it of their arcs
PlanRegion grown(const PlanRegion& region, double distance, double tolerance = 0.001);
/// The same region without corners that lie within about `tolerance` mm of the line between their neighbours.
PlanRegion cleaned(const PlanRegion& region, double tolerance);
/// The points within `distance` > 0 of an open line, with square ends.
PlanRegion around(const std::vector<glm::dvec2>& line, double distance);
/// The area painted by a round brush along a line, which may be a single point. @param radius  mm, > 0
PlanRegion brushed(const std::vector<glm::dvec2>& line, double radius);
PlanRegion joined(const PlanRegion& one, const PlanRegion& other);
PlanRegion without(const PlanRegion& one, const PlanRegion& other);
/// The points around which the rings turn more often in one direction than in the other, as the outlines of a surface
/// do.
PlanRegion filledBy(const std::vector<PlanRing>& rings);
/// mm²
double areaInPlan(const PlanRegion& region);
std::vector<PlanPiece> piecesOf(const PlanRegion& region);
/// The same region with its rings turned so that it lies on their left.
PlanRegion oriented(const PlanRegion& region);

} // namespace burin
