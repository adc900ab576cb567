// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/placement.h"

#include <vtkActor.h>
#include <vtkMatrix4x4.h>
#include <vtkPlane.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <QColor>

#include <glm/glm.hpp>

#include <span>
#include <utility>

namespace burin {

/// An actor for a lit surface. `surface` contains points, normals and triangles.
vtkSmartPointer<vtkActor> surfaceActor(vtkPolyData* surface);
/// An actor for unlit lines.
vtkSmartPointer<vtkActor> lineActor(vtkPolyData* lines);
/// As `lineActor`, but drawn slightly nearer to the eye than the surface on which the lines lie; a larger height draws
/// them nearer.
inline constexpr double seamHeight = 3.0, raisedHeight = 4.0, overSeamHeight = 6.0;
vtkSmartPointer<vtkActor> raisedLineActor(vtkPolyData* lines, double height = raisedHeight);
void setColour(vtkActor& actor, const QColor& colour);
void setMatrix(vtkMatrix4x4& matrix, const Placement& placement);
void setLineWidth(vtkActor& actor, double screenPixels);
/// Draws only what a plane doesn't cut off; null: everything.
void clipBy(vtkActor& actor, vtkPlane* plane);
/// Blends an actor over what is already drawn (actors are drawn in the order in which they were added). VTK's own
/// translucent pass would need several full-screen buffers, which are costly in every frame with software OpenGL.
void setBlended(vtkActor& actor, double opacity);

/// The two end points of a line, mm.
using LineEnds = std::pair<glm::dvec3, glm::dvec3>;
vtkSmartPointer<vtkPolyData> lineData(std::span<const LineEnds> lines);

/// Line widths in device-independent pixels, to be scaled by the screen's pixel ratio.
inline constexpr double thinLine = 1.0, edgeLine = 1.5, pathLine = 2.0, boldLine = 2.5;

} // namespace burin
