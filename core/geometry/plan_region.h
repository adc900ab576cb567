// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <vector>

namespace burin {

/// Corners of a polygon in plan, mm, closed by itself.
using PlanRing = std::vector<glm::dvec2>;

/// A region in plan, mm: what lies within an odd number of its rings. Any number of threads may read one.
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

/// Farthest place that the functions below take, mm from the origin along each axis; they work on a grid of 1e-4 mm.
inline constexpr double farthestInPlan = 1e5;

PlanRegion rectangle(const glm::dvec2& low, const glm::dvec2& high);
/// All 0 for an empty region.
PlanBounds boundsOf(const PlanRegion& region) noexcept;
bool holds(const PlanRegion& region, const glm::dvec2& place) noexcept;

/// What lies within `distance` of a region; for a negative one what of the region is farther from its border than that.
/// @param tolerance mm: round corners are chords within it of their arcs
PlanRegion grown(const PlanRegion& region, double distance, double tolerance = 0.001);
/// The same without corners that lie within about `tolerance` mm of the line between their neighbours.
PlanRegion cleaned(const PlanRegion& region, double tolerance);
/// What lies within `distance` > 0 of a line that is open, ends square.
PlanRegion around(const std::vector<glm::dvec2>& line, double distance);
/// What a round brush paints along a line, that is also a single place. @param radius mm, > 0
PlanRegion brushed(const std::vector<glm::dvec2>& line, double radius);
PlanRegion joined(const PlanRegion& one, const PlanRegion& other);
PlanRegion without(const PlanRegion& one, const PlanRegion& other);
/// What lies within rings that turn more often one way than the other about it, as the outlines of a surface do.
PlanRegion filledBy(const std::vector<PlanRing>& rings);
/// mm²
double areaInPlan(const PlanRegion& region);
std::vector<PlanPiece> piecesOf(const PlanRegion& region);

} // namespace burin
