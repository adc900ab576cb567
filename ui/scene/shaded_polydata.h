// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/scene/shaded_mesh.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace burin {

/// A shaded mesh as VTK data.
struct ShadedPolyData {
    vtkSmartPointer<vtkPolyData> surface; ///< with normals
    vtkSmartPointer<vtkPolyData> creases; ///< lines
};
ShadedPolyData polyDataOf(const ShadedMesh& mesh);

} // namespace burin
