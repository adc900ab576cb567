// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/aim_camera.h"

#include "core/base/units.h"

#include <algorithm>

namespace burin {
namespace {

constexpr double usualReach = 2048.0; // mm

} // namespace

void aim(vtkCamera& camera, const CameraView& view, double reach) {
    const CameraAxes axes = axesOf(view);
    const bool parallel = isParallel(view);
    // No farther away than necessary, because the graphics card computes with seven digits; and always from the same
    // position, or pixels would flicker whenever something is drawn farther out.
    const glm::dvec3 eye = parallel ? view.focus + axes.back * std::max(usualReach, 2.0 * reach) : axes.eye;
    camera.SetPosition(eye.x, eye.y, eye.z);
    camera.SetFocalPoint(view.focus.x, view.focus.y, view.focus.z);
    camera.SetViewUp(axes.up.x, axes.up.y, axes.up.z);
    camera.SetParallelProjection(parallel);
    if (parallel)
        camera.SetParallelScale(halfHeightOf(view));
    else
        camera.SetViewAngle(angleOf(view) * 180.0 / pi);
}

} // namespace burin
