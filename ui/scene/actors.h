// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vtkActor.h>
#include <vtkPlane.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <QColor>

#include <glm/glm.hpp>

#include <span>
#include <utility>

namespace burin {

/// A lit surface. Points, normals and triangles stand in `surface`.
vtkSmartPointer<vtkActor> surfaceActor(vtkPolyData* surface);
/// Lines in their plain colour.
vtkSmartPointer<vtkActor> lineActor(vtkPolyData* lines);
/// The same, drawn a little nearer than the surface that they lie on; the higher, the nearer.
inline constexpr double seamHeight = 3.0, raisedHeight = 4.0, overSeamHeight = 6.0;
vtkSmartPointer<vtkActor> raisedLineActor(vtkPolyData* lines, double height = raisedHeight);
void setColour(vtkActor& actor, const QColor& colour);
void setLineWidth(vtkActor& actor, double screenPixels);
/// Draws only what a plane doesn't cut off; null: all.
void clipBy(vtkActor& actor, vtkPlane* plane);
/// Blends an actor over what is already drawn (actors are drawn in the order in which they were added). VTK's own
/// translucent pass would cost several full-screen buffers, which software OpenGL pays for with every frame.
void setBlended(vtkActor& actor, double opacity);

/// Lines, each between two places, mm.
using LineEnds = std::pair<glm::dvec3, glm::dvec3>;
vtkSmartPointer<vtkPolyData> lineData(std::span<const LineEnds> lines);

/// Widths that are given in device-independent pixels follow the screen.
inline constexpr double thinLine = 1.0, edgeLine = 1.5, pathLine = 2.0, boldLine = 2.5;

} // namespace burin
