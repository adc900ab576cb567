// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <span>

namespace burin {

/// A point of a surface with its outward normal.
struct SurfacePoint {
    glm::dvec3 place{0.0};  ///< mm
    glm::dvec3 normal{0.0}; ///< unit
};

/// A plane, cylinder or sphere through points of a surface.
struct FittedSurface {
    enum class Kind : std::uint8_t { plane, cylinder, sphere };
    Kind kind = Kind::plane;
    glm::dvec3 place{0.0}; ///< mm: a point of the plane, a point on the axis, or the centre
    glm::dvec3 axis{0.0};  ///< unit: the plane's outward normal, or the axis; zero for a sphere
    double radius = 0.0;   ///< mm; 0 for a plane
    double side = 1.0;     ///< 1: outward is away from the axis or centre (a boss); -1: towards it (a hole)

    /// mm, positive outwards.
    double distance(const glm::dvec3& point) const noexcept;
    /// Outward, unit; zero on the axis or at the centre.
    glm::dvec3 normal(const glm::dvec3& point) const noexcept;
    glm::dvec3 closest(const glm::dvec3& point) const noexcept { return point - distance(point) * normal(point); }
};

/// Fits by least squares of the distances (Gauss-Newton; a cylinder starts at the direction that is most nearly
/// perpendicular to all normals, circle and sphere at their algebraic fit). Empty if the points determine no such
/// surface: too few, or a cylinder or sphere through points of a plane.
std::optional<FittedSurface> fitSurface(FittedSurface::Kind kind, std::span<const SurfacePoint> points);

} // namespace burin
