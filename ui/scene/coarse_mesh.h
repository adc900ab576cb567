// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/scene/shaded_mesh.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace burin {

/// The surface of a mesh with fewer triangles: a subset of its points, with their normals. Creases and borders are
/// unchanged; the remaining surface deviates by no more than the tolerance. Any thread.
/// @param tolerance mm
vtkSmartPointer<vtkPolyData> coarsened(const ShadedMesh& mesh, double tolerance);

} // namespace burin
