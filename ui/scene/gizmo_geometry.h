// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/scene/camera_view.h"
#include "ui/scene/gizmo.h"

#include <vector>

namespace burin {

/// A polyline, mm, setup frame.
using GizmoLine = std::vector<glm::dvec3>;

/// Sizes of a gizmo, device-independent pixels at its centre.
inline constexpr double gizmoArrowStart = 10.0, gizmoArrowLength = 74.0, gizmoHeadLength = 13.0, gizmoRingRadius = 52.0,
                        gizmoSquareStart = 14.0, gizmoSquareEnd = 28.0;
/// Distance from a line of a handle within which the pointer grips it, likewise.
inline constexpr double gizmoReach = 6.0;

glm::dvec3 axisDirection(int axis) noexcept; ///< unit

/// Unit vector from a point towards the eye.
glm::dvec3 towardsEye(const CameraView& view, const glm::dvec3& place) noexcept;

/// The handles that a view offers: no arrow that points at the eye or away from it, no square and no ring that is seen
/// from its edge, as the pointer could not drag them.
std::vector<GizmoHandle> offeredHandles(const Gizmo& gizmo, const CameraView& view);

/// The line of a handle, mm, setup frame: from the start of an arrow to its tip, around a square, along the half of a
/// ring that is nearer to the eye (all of it if it faces the eye).
/// @param pixel mm per device-independent pixel at the centre
GizmoLine handleLine(const Gizmo& gizmo, const GizmoHandle& handle, const CameraView& view, double pixel);

/// The handle that the pointer grips; of several, the one nearest to the eye. Empty: none.
/// @param size of the widget @param pointer device-independent pixels
std::optional<GizmoHandle> handleAt(const Gizmo& gizmo, const CameraView& view, const QSizeF& size,
                                    const QPointF& pointer);

} // namespace burin
