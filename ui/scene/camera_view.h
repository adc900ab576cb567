// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/box.h"
#include "ui/scene/sight.h"
#include "ui/scene/viewport.h"

#include <QPointF>
#include <QSizeF>

namespace burin {

/// The position and direction of the eye: a turntable camera about z, so the picture never rolls. Any elevation,
/// including ± 90°, is well defined.
struct CameraView {
    glm::dvec3 focus{0.0};   ///< mm, setup frame: the point at which the eye looks
    double azimuth = 0.0;    ///< rad about z from +x: heading from the focus to the eye
    double elevation = 0.0;  ///< rad above the horizontal plane, -π/2 … π/2
    double distance = 300.0; ///< mm from the focus to an eye in perspective; the size of the picture at the focus is
                             ///< kept in other projections
    /// 1: perspective. 0: parallel, the eye infinitely far away. Values in between occur only during the transition:
    /// the eye moves back and its angle narrows, and points as far away as the focus keep their position in the
    /// picture.
    double convergence = 1.0;
};

/// The vertical view angle, rad. It is narrow so that there is little distortion and sizes can be compared.
inline constexpr double cameraViewAngle = 0.4886921905584123; // 28°

/// The camera's unit axes and its position, setup frame.
struct CameraAxes {
    /// `back`: from the focus to the eye, which is far away if the projection is parallel
    glm::dvec3 eye{0.0}, right{0.0}, up{0.0}, back{0.0};
};
CameraAxes axesOf(const CameraView& view) noexcept;
/// Whether all sight lines have (practically) the same direction.
bool isParallel(const CameraView& view) noexcept;
/// Half the height of the picture at the focus, mm.
double halfHeightOf(const CameraView& view) noexcept;
/// The vertical view angle, rad; only for views that are not parallel.
double angleOf(const CameraView& view) noexcept;

// Positions in the widget are in device-independent pixels from its top left; `size` is the size of the widget.

/// The sight line through a position of the widget. In a parallel view it starts far in front of all possible content.
Sight sightThrough(const CameraView& view, const QSizeF& size, const QPointF& position);
/// The inverse of `sightThrough`: where a point appears. Meaningless for points behind the eye.
QPointF appearanceOf(const CameraView& view, const QSizeF& size, const glm::dvec3& place);
/// The length that one pixel covers at a point, perpendicular to the line of sight, mm.
double pixelAt(const CameraView& view, const QSizeF& size, const glm::dvec3& place);

/// The view rotated about `pivot`, which keeps its position in the picture. The elevation is limited to ± 90°.
CameraView orbited(const CameraView& view, double azimuth, double elevation, const glm::dvec3& pivot);
/// The view moved so that `grip` follows a pointer that moved by `pixels`.
CameraView panned(const CameraView& view, const QSizeF& size, const QPointF& pixels, const glm::dvec3& grip);
/// The view with every distance from `pivot` multiplied by `factor`: the pivot keeps its position in the picture.
CameraView zoomed(const CameraView& view, double factor, const glm::dvec3& pivot);
/// The view in the same direction, so close that the box fills the picture except for a margin. An empty box changes
/// nothing.
CameraView fitted(const CameraView& view, const QSizeF& size, const Box& box);
/// The view with another convergence; points as far away as `pivot` keep their position in the picture.
CameraView converged(const CameraView& view, double convergence, const glm::dvec3& pivot);
/// The point where a sight line passes the focus: used for the position under the pointer if there is nothing else.
glm::dvec3 besideFocus(const CameraView& view, const Sight& sight);
/// The view in the direction of a standard view; focus, distance and convergence are kept.
CameraView turnedTo(const CameraView& view, StandardView standard);
/// Interpolates between two views, with the azimuth along the shorter arc. @param share 0 … 1
CameraView between(const CameraView& from, const CameraView& to, double share);

} // namespace burin
