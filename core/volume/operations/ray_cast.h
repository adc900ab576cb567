// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/run_volume.h"

#include <limits>
#include <optional>
#include <vector>

namespace burin {

/// Which runs stop a ray.
enum class RayTarget : std::uint8_t { anything, protectedOnly };

/// Where a ray first meets a workpiece.
struct RayHit {
    glm::dvec3 place{0.0}; ///< mm, setup frame
    double distance = 0.0; ///< mm from the ray's origin
    PropertyIndex property = airProperty;
};

/// The first run that a ray meets: exact on run ends, resolved to the scanline's own column across them.
/// @param origin  mm, setup frame  @param direction  of any length but 0
/// @return empty if the ray misses or is invalid: origin or direction not finite, or a direction without length
/// Thread   any.
/// Cost     grows with the scanlines that the ray passes, and with their runs.
std::optional<RayHit> castRay(const VolumeSnapshot& workpiece, const glm::dvec3& origin, const glm::dvec3& direction,
                              RayTarget target = RayTarget::anything);

/// A part of a ray, mm from its origin.
struct RayInterval {
    double from = 0.0, to = 0.0;
};

/// The parts of a ray that lie in material, in order and apart from each other: exact on run ends, resolved to the
/// scanline's own column across them. Materials are not told apart. Arguments as for castRay.
/// @param reach  mm: nothing beyond this distance is looked at
/// @return empty if the ray meets nothing or is invalid
/// Thread   any.
/// Cost     grows with the scanlines that the ray passes, and with their runs.
std::vector<RayInterval> materialAlong(const VolumeSnapshot& workpiece, const glm::dvec3& origin,
                                       const glm::dvec3& direction,
                                       double reach = std::numeric_limits<double>::infinity());

/// The highest end of any run within a distance of a point, measured across the runs.
/// @param place  mm, setup frame, along the grid's axes of u and v (runs along z: x, y)  @param radius  mm
/// @return mm along the runs, setup frame; the grid's low end if there is no run, or if place or radius is not finite
/// Thread   any.
/// Cost     grows with the scanlines within the radius, and with their runs.
double highestWithin(const VolumeSnapshot& workpiece, const glm::dvec2& place, double radius);

} // namespace burin
