// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/triangle_mesh.h"
#include "core/tool/tool.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace burin {

/// The surface of one piece of a tool, mm, tip at the origin, axis +Z, with normals.
vtkSmartPointer<vtkPolyData> pieceSurface(const RevolvedPiece& piece);

/// The surface of a mesh, with normals; sharp edges stay sharp.
vtkSmartPointer<vtkPolyData> meshSurface(const TriangleMesh& mesh);

/// The surface of the flutes: of their pieces, or of the solid of a tool that doesn't turn or is hollow; as
/// `pieceSurface`, in the setup frame's directions.
vtkSmartPointer<vtkPolyData> flutesSurface(const Cutter& cutter);

} // namespace burin
