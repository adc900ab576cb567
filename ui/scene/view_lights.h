// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/box.h"

#include <vtkActor.h>
#include <vtkRenderer.h>

#include <QColor>

namespace burin {

/// Adds lights that move with the camera: a strong one from the upper left, so that faces of different directions
/// differ and a groove is recognised as a groove, a weak one from the right, and ambient light like that of a bright
/// sky.
void addViewLights(vtkRenderer& renderer);

/// Sets the background gradient.
void setBackdrop(vtkRenderer& renderer, const QColor& top, const QColor& bottom);

/// Shades a matt surface by the workpiece's lights as for a distant eye: without the reflection, power or square root
/// per light and pixel that take half of a frame's time in software rendering. Concave edges are darker, convex ones
/// lighter. For surfaces with point normals.
void shadeSimply(vtkActor& actor);

/// The range of distances from the eye, mm, along the direction of sight, over which a surface gets dimmer, so that
/// floors of the same direction at different depths can be distinguished.
struct DepthCue {
    double nearest = 0.0, farthest = 0.0;
};
/// The depth cue from the nearest to the farthest corner of a box. @param along unit. An empty box: none.
DepthCue depthCueOf(const Box& box, const glm::dvec3& eye, const glm::dvec3& along);
/// Sets the depth cue of an actor that is shaded by `shadeSimply`.
void setDepthCue(vtkActor& actor, const DepthCue& cue);

} // namespace burin
