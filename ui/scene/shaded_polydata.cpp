// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/shaded_polydata.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkTypeInt32Array.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>

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

constexpr const char* faceColourArray = "faceColours"; // four components, as ShadedMesh::colours

vtkSmartPointer<vtkUnsignedCharArray> colourArray(const std::vector<std::array<std::uint8_t, 4>>& colours) {
    auto array = vtkSmartPointer<vtkUnsignedCharArray>::New();
    array->SetName(faceColourArray);
    array->SetNumberOfComponents(4);
    array->SetNumberOfTuples(static_cast<vtkIdType>(colours.size()));
    for (std::size_t i = 0; i < colours.size(); ++i) array->SetTypedTuple(static_cast<vtkIdType>(i), colours[i].data());
    return array;
}

vtkUnsignedCharArray* faceColoursOf(vtkPolyData& surface) {
    return vtkUnsignedCharArray::SafeDownCast(surface.GetPointData()->GetArray(faceColourArray));
}

} // namespace

bool hasFaceColours(vtkPolyData& surface) {
    return faceColoursOf(surface) != nullptr;
}

void colourFaces(vtkPolyData& surface, const QColor& body) {
    vtkUnsignedCharArray* const own = faceColoursOf(surface);
    if (own == nullptr) return;
    const std::array<unsigned char, 3> other{static_cast<unsigned char>(body.red()),
                                             static_cast<unsigned char>(body.green()),
                                             static_cast<unsigned char>(body.blue())};
    vtkNew<vtkUnsignedCharArray> colours;
    colours->SetName("colours");
    colours->SetNumberOfComponents(3);
    colours->SetNumberOfTuples(own->GetNumberOfTuples());
    std::array<unsigned char, 4> colour{};
    for (vtkIdType i = 0; i < own->GetNumberOfTuples(); ++i) {
        own->GetTypedTuple(i, colour.data());
        colours->SetTypedTuple(i, colour[3] == 0 ? other.data() : colour.data());
    }
    surface.GetPointData()->SetScalars(colours);
}

ShadedPolyData polyDataOf(const ShadedMesh& mesh) {
    vtkNew<vtkPoints> points;
    points->SetData(floats(mesh.points));
    ShadedPolyData data{vtkSmartPointer<vtkPolyData>::New(), vtkSmartPointer<vtkPolyData>::New()};
    data.surface->SetPoints(points);
    data.surface->GetPointData()->SetNormals(floats(mesh.normals));
    if (!mesh.colours.empty()) data.surface->GetPointData()->AddArray(colourArray(mesh.colours));
    data.surface->SetPolys(cells(mesh.triangles, 3));
    data.creases->SetPoints(points);
    data.creases->SetLines(cells(mesh.creases, 2));
    return data;
}

} // namespace burin
