// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/coarse_mesh.h"

#include "ui/scene/shaded_polydata.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkDecimatePro.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>

namespace burin {

namespace {

constexpr double mostLeftOut = 0.98; ///< of the triangles

} // namespace

ShadedMesh coarsened(const ShadedMesh& mesh, double tolerance) {
    vtkNew<vtkDecimatePro> decimation;
    decimation->SetInputData(polyDataOf(mesh).surface);
    decimation->SetTargetReduction(mostLeftOut);
    decimation->PreserveTopologyOn();
    decimation->SplittingOff();
    decimation->BoundaryVertexDeletionOff(); // a crease is a border of the faces on both its sides
    decimation->SetErrorIsAbsolute(1);
    decimation->SetAbsoluteError(tolerance);
    decimation->AccumulateErrorOn();
    decimation->Update();
    vtkPolyData& fewer = *decimation->GetOutput();
    ShadedMesh coarse;
    for (vtkIdType point = 0; point < fewer.GetNumberOfPoints(); ++point) {
        glm::dvec3 place, normal;
        fewer.GetPoint(point, &place.x);
        fewer.GetPointData()->GetNormals()->GetTuple(point, &normal.x);
        coarse.points.emplace_back(place);
        coarse.normals.emplace_back(normal);
    }
    vtkNew<vtkIdList> corners;
    vtkCellArray& triangles = *fewer.GetPolys();
    for (triangles.InitTraversal(); triangles.GetNextCell(corners) != 0;)
        for (const vtkIdType corner : *corners) coarse.triangles.push_back(static_cast<std::uint32_t>(corner));
    return coarse;
}

} // namespace burin
