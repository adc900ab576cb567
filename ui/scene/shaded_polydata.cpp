// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/shaded_polydata.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkTypeInt32Array.h>

#include <algorithm>

namespace burin {
namespace {

vtkSmartPointer<vtkFloatArray> floats(const std::vector<glm::vec3>& vectors) {
    auto array = vtkSmartPointer<vtkFloatArray>::New();
    array->SetNumberOfComponents(3);
    array->SetNumberOfTuples(static_cast<vtkIdType>(vectors.size()));
    for (std::size_t i = 0; i < vectors.size(); ++i) array->SetTypedTuple(static_cast<vtkIdType>(i), &vectors[i].x);
    return array;
}

vtkSmartPointer<vtkCellArray> cells(const std::vector<std::uint32_t>& corners, vtkIdType cornersEach) {
    vtkNew<vtkTypeInt32Array> connectivity;
    connectivity->SetNumberOfValues(static_cast<vtkIdType>(corners.size()));
    std::ranges::transform(corners, connectivity->GetPointer(0),
                           [](std::uint32_t corner) { return static_cast<vtkTypeInt32>(corner); });
    auto array = vtkSmartPointer<vtkCellArray>::New();
    array->SetData(cornersEach, connectivity);
    return array;
}

} // namespace

ShadedPolyData polyDataOf(const ShadedMesh& mesh) {
    vtkNew<vtkPoints> points;
    points->SetData(floats(mesh.points));
    ShadedPolyData data{vtkSmartPointer<vtkPolyData>::New(), vtkSmartPointer<vtkPolyData>::New()};
    data.surface->SetPoints(points);
    data.surface->GetPointData()->SetNormals(floats(mesh.normals));
    data.surface->SetPolys(cells(mesh.triangles, 3));
    data.creases->SetPoints(points);
    data.creases->SetLines(cells(mesh.creases, 2));
    return data;
}

} // namespace burin
