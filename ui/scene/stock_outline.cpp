// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/stock_outline.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkPropCollection.h>
#include <vtkProperty.h>

#include <array>

namespace burin {
namespace {

vtkSmartPointer<vtkPoints> corners(const Box& box) {
    auto points = vtkSmartPointer<vtkPoints>::New();
    for (unsigned i = 0; i < 8; ++i) {
        const glm::dvec3 corner = box.corner(i);
        points->InsertNextPoint(corner.x, corner.y, corner.z);
    }
    return points;
}

void setData(vtkActor& actor, vtkPolyData* data) {
    vtkPolyDataMapper::SafeDownCast(actor.GetMapper())->SetInputData(data);
}

} // namespace

StockOutline::StockOutline(vtkRenderer& renderer)
    : renderer_(renderer), edges_(lineActor(vtkNew<vtkPolyData>())), faces_(surfaceActor(vtkNew<vtkPolyData>())) {
    faces_->GetProperty()->LightingOff();
    faces_->GetProperty()->BackfaceCullingOn();
    setBlended(*edges_, 0.7);
    setBlended(*faces_, 0.13);
    faces_->PickableOff();
    renderer.AddActor(edges_);
    renderer.AddActor(faces_);
    refresh();
}

void StockOutline::setColour(const QColor& colour) {
    burin::setColour(*edges_, colour);
    burin::setColour(*faces_, colour);
}

void StockOutline::setBox(const std::optional<Box>& stock) {
    stock_ = stock && !stock->empty() ? stock : std::nullopt;
    refresh();
}

void StockOutline::setFaces(bool visible) {
    facesRequested_ = visible;
    refresh();
}

void StockOutline::drawLast() {
    if (renderer_.GetViewProps()->GetLastProp() == faces_.Get()) return;
    renderer_.RemoveActor(faces_);
    renderer_.AddActor(faces_);
}

void StockOutline::refresh() {
    edges_->SetVisibility(stock_.has_value());
    faces_->SetVisibility(stock_.has_value() && facesRequested_);
    if (!stock_) return;
    const vtkSmartPointer<vtkPoints> points = corners(*stock_);
    vtkNew<vtkCellArray> lines, quads;
    constexpr std::array<std::array<vtkIdType, 2>, 12> edges{
        {{0, 1}, {2, 3}, {4, 5}, {6, 7}, {0, 2}, {1, 3}, {4, 6}, {5, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};
    for (const auto& edge : edges) lines->InsertNextCell(2, edge.data());
    constexpr std::array<std::array<vtkIdType, 4>, 6> sides{
        {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
    for (const auto& side : sides) quads->InsertNextCell(4, side.data());
    vtkNew<vtkPolyData> outline, surface;
    outline->SetPoints(points);
    outline->SetLines(lines);
    surface->SetPoints(points);
    surface->SetPolys(quads);
    setData(*edges_, outline);
    setData(*faces_, surface);
}

} // namespace burin
