// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/box.h"
#include "ui/scene/sight.h"
#include "ui/scene/viewport.h"

#include <QPointF>
#include <QSizeF>

namespace burin {

/// Where the eye stands: a turntable about z, so the picture never rolls. Any elevation, ± 90° included, is well
/// defined.
struct CameraView {
    glm::dvec3 focus{0.0};  ///< mm, setup frame: what the eye looks at
    double azimuth = 0.0;   ///< rad about z from +x: heading from the focus to the eye
    double elevation = 0.0; ///< rad over the horizontal plane, -π/2 … π/2
    double distance =
        300.0; ///< mm from the focus to an eye in perspective: what the picture shows there stays as large
    /// 1: perspective. 0: parallel, the eye infinitely far away. Between them only while one becomes the other: the eye
    /// draws back and its angle narrows, and what lies as far away as the focus keeps its place in the picture.
    double convergence = 1.0;
};

/// The whole height of the picture, rad. Narrow: little distortion, and sizes can be compared.
inline constexpr double cameraViewAngle = 0.4886921905584123; // 28°

/// Unit axes of the camera and its place, setup frame.
struct CameraAxes {
    /// `back`: from the focus to the eye, which stands far away where the picture is parallel
    glm::dvec3 eye{0.0}, right{0.0}, up{0.0}, back{0.0};
};
CameraAxes axesOf(const CameraView& view) noexcept;
/// All sights run in one direction (or as good as).
bool isParallel(const CameraView& view) noexcept;
/// Half the height of the picture at the focus, mm.
double halfHeightOf(const CameraView& view) noexcept;
/// The whole height of the picture as the eye sees it, rad; of a picture that is not parallel.
double angleOf(const CameraView& view) noexcept;

// Places in the widget: device-independent pixels from its top left; `size` is the widget's.

/// In a parallel picture it begins far before everything that there may be.
Sight sightThrough(const CameraView& view, const QSizeF& size, const QPointF& position);
/// The inverse. Has no meaning for places behind the eye.
QPointF appearanceOf(const CameraView& view, const QSizeF& size, const glm::dvec3& place);
/// mm that one pixel covers at a place, square to the line of sight.
double pixelAt(const CameraView& view, const QSizeF& size, const glm::dvec3& place);

/// Turned about a place that keeps its position in the picture. Elevation stops at ± 90°.
CameraView orbited(const CameraView& view, double azimuth, double elevation, const glm::dvec3& pivot);
/// Moved so that `grip` follows a pointer that moved by `pixels`.
CameraView panned(const CameraView& view, const QSizeF& size, const QPointF& pixels, const glm::dvec3& grip);
/// Every distance from `pivot` times `factor`: the pivot keeps its position in the picture.
CameraView zoomed(const CameraView& view, double factor, const glm::dvec3& pivot);
/// The same direction, so near that the box just fills the picture but for a margin. An empty box changes nothing.
CameraView fitted(const CameraView& view, const QSizeF& size, const Box& box);
/// Of another convergence; all that is as far away as `pivot` keeps its place in the picture.
CameraView converged(const CameraView& view, double convergence, const glm::dvec3& pivot);
/// Where a sight passes the focus: the place under the pointer where there is nothing else.
glm::dvec3 besideFocus(const CameraView& view, const Sight& sight);
/// The direction of a standard view; focus, distance and convergence kept.
CameraView turnedTo(const CameraView& view, StandardView standard);
/// Between two views, the short way round. @param share 0 … 1
CameraView between(const CameraView& from, const CameraView& to, double share);

} // namespace burin
