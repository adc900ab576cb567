// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/actors.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

namespace burin {
namespace {

/// Offsets lines in depth, < 0 towards the eye. VTK enables this for all mappers of the program at once and adds its
/// global parameters to those of each mapper, so they are subtracted for each mapper.
void offsetLines(vtkMapper& mapper, double units) {
    vtkMapper::SetResolveCoincidentTopologyToPolygonOffset();
    double everyFactor = 0.0, everyUnits = 0.0;
    vtkMapper::GetResolveCoincidentTopologyLineOffsetParameters(everyFactor, everyUnits);
    mapper.SetRelativeCoincidentTopologyLineOffsetParameters(-everyFactor, units - everyUnits);
}

} // namespace

vtkSmartPointer<vtkActor> surfaceActor(vtkPolyData* surface) {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(surface);
    mapper->ScalarVisibilityOff();
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    actor->GetProperty()->SetSpecular(0.2);
    actor->GetProperty()->SetSpecularPower(30.0);
    return actor;
}

vtkSmartPointer<vtkActor> lineActor(vtkPolyData* lines) {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(lines);
    mapper->ScalarVisibilityOff();
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    actor->GetProperty()->LightingOff();
    actor->PickableOff();
    offsetLines(*mapper, 0.0);
    return actor;
}

vtkSmartPointer<vtkActor> raisedLineActor(vtkPolyData* lines, double height) {
    vtkSmartPointer<vtkActor> actor = lineActor(lines);
    offsetLines(*actor->GetMapper(), -height);
    return actor;
}

void setMatrix(vtkMatrix4x4& matrix, const Placement& placement) {
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) matrix.SetElement(row, column, placement.turn[column][row]);
        matrix.SetElement(row, 3, placement.shift[row]);
    }
}

void setColour(vtkActor& actor, const QColor& colour) {
    actor.GetProperty()->SetColor(colour.redF(), colour.greenF(), colour.blueF());
}

void setLineWidth(vtkActor& actor, double screenPixels) {
    actor.GetProperty()->SetLineWidth(static_cast<float>(screenPixels));
}

void clipBy(vtkActor& actor, vtkPlane* plane) {
    actor.GetMapper()->RemoveAllClippingPlanes();
    if (plane != nullptr) actor.GetMapper()->AddClippingPlane(plane);
}

void setBlended(vtkActor& actor, double opacity) {
    actor.GetProperty()->SetOpacity(opacity);
    actor.ForceOpaqueOn();
}

vtkSmartPointer<vtkPolyData> lineData(std::span<const LineEnds> lines) {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToFloat();
    points->SetNumberOfPoints(static_cast<vtkIdType>(2 * lines.size()));
    vtkNew<vtkCellArray> cells;
    cells->AllocateExact(static_cast<vtkIdType>(lines.size()), static_cast<vtkIdType>(2 * lines.size()));
    vtkIdType next = 0;
    for (const auto& [from, to] : lines) {
        points->SetPoint(next, from.x, from.y, from.z);
        points->SetPoint(next + 1, to.x, to.y, to.z);
        cells->InsertNextCell({next, next + 1});
        next += 2;
    }
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->SetLines(cells);
    return data;
}

} // namespace burin
