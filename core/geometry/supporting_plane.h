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

/// Of a piece's signed distance, at a point of a surface where it is least or nearly so. On a ridge of the distance,
/// where two of the piece's faces are equally near, every mean of their slopes supports; this is the one that is most
/// nearly along the surface's normal, as it is at a least value over a smooth surface. No point of the surface that
/// lies on the plane's far side has less.
/// @param normal  of the surface, unit length  @param ridge  mm: how far from the point a ridge may pass
SupportingPlane supportingPlane(const PlacedPiece& piece, const glm::dvec3& point, const glm::dvec3& normal,
                                double ridge) noexcept;

} // namespace burin
