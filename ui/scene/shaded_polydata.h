// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/scene/shaded_mesh.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <QColor>

namespace burin {

/// A shaded mesh as VTK data.
struct ShadedPolyData {
    vtkSmartPointer<vtkPolyData> surface; ///< with normals
    vtkSmartPointer<vtkPolyData> creases; ///< lines
};
ShadedPolyData polyDataOf(const ShadedMesh& mesh);

/// Whether faces of a surface that polyDataOf made, or one that was made of it, have colours of their own.
bool hasFaceColours(vtkPolyData& surface);
/// Sets the colours of such a surface's points. @param body colour of the faces without one of their own
void colourFaces(vtkPolyData& surface, const QColor& body);

} // namespace burin
