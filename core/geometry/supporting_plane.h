// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/piece_minimum.h"

namespace burin {

/// A plane that a convex function stays above: its value at x is at least value + slope · (x - at).
struct SupportingPlane {
    glm::dvec3 at{0.0};
    double value = 0.0;
    glm::dvec3 slope{0.0};
};

/// A supporting plane of a piece's signed distance, at a point of a surface where it is least or nearly so. On a ridge
/// of the distance, where two of the piece's faces are equally near, every mean of their slopes is a supporting one;
/// this is the one closest to the direction of the surface's normal, as at a minimum over a smooth surface. No point of
/// the surface on the plane's far side has a smaller distance.
/// @param normal  of the surface, unit length  @param ridge  mm: distance from the point within which a ridge is
///        considered
SupportingPlane supportingPlane(const PlacedPiece& piece, const glm::dvec3& point, const glm::dvec3& normal,
                                double ridge) noexcept;

} // namespace burin
