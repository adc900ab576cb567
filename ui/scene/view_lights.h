// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/box.h"

#include <vtkActor.h>
#include <vtkRenderer.h>

#include <QColor>

namespace burin {

/// Lights that go with the eye: a strong one from the upper left, so that faces of every direction differ and a groove
/// reads as a groove, a weak one from the right, and what a bright sky gives.
void addViewLights(vtkRenderer& renderer);

/// What is seen behind everything.
void setBackdrop(vtkRenderer& renderer, const QColor& top, const QColor& bottom);

/// Shades a matt surface by the workpiece's lights as an eye far away would see it: no reflection, power or root a
/// light and pixel, which in software takes half of the time of a picture. Hollow edges are darker, raised ones
/// lighter. For surfaces with normals at their points.
void shadeSimply(vtkActor& actor);

/// Between which distances from the eye a surface gets dimmer, mm, along the direction of sight: floors of one
/// direction at different depths are told apart.
struct DepthCue {
    double nearest = 0.0, farthest = 0.0;
};
/// From the nearest to the farthest corner of a box. @param along unit. An empty box: none.
DepthCue depthCueOf(const Box& box, const glm::dvec3& eye, const glm::dvec3& along);
/// Of an actor that `shadeSimply` shades.
void setDepthCue(vtkActor& actor, const DepthCue& cue);

} // namespace burin
