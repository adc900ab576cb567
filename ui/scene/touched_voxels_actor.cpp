// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/touched_voxels_actor.h"

#include "ui/scene/actors.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <array>

namespace burin {

namespace {

void addCube(const Box& cube, vtkPoints& points, vtkCellArray& quads) {
    constexpr std::array<std::array<vtkIdType, 4>, 6> sides{
        {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
    const vtkIdType first = points.GetNumberOfPoints();
    for (unsigned i = 0; i < 8; ++i) {
        const glm::dvec3 corner = cube.corner(i);
        points.InsertNextPoint(corner.x, corner.y, corner.z);
    }
    for (const auto& side : sides) {
        quads.InsertNextCell(4);
        for (const vtkIdType corner : side) quads.InsertCellPoint(first + corner);
    }
}

} // namespace

TouchedVoxelsActor::TouchedVoxelsActor(vtkRenderer& renderer) : cubes_(surfaceActor(vtkNew<vtkPolyData>())) {
    cubes_->GetProperty()->EdgeVisibilityOn();
    cubes_->GetProperty()->SetInterpolationToFlat();
    cubes_->PickableOff();
    cubes_->VisibilityOff();
    renderer.AddActor(cubes_);
}

void TouchedVoxelsActor::setColours(const QColor& faces, const QColor& edges) {
    setColour(*cubes_, faces);
    cubes_->GetProperty()->SetEdgeColor(edges.redF(), edges.greenF(), edges.blueF());
}

void TouchedVoxelsActor::set(const std::vector<TouchedVoxels>& areas) {
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> quads;
    for (const TouchedVoxels& area : areas)
        for (const glm::dvec3& centre : area.centres)
            addCube({centre - 0.5 * area.edge, centre + 0.5 * area.edge}, *points, *quads);
    vtkNew<vtkPolyData> cubes;
    cubes->SetPoints(points);
    cubes->SetPolys(quads);
    vtkPolyDataMapper::SafeDownCast(cubes_->GetMapper())->SetInputData(cubes);
    cubes_->SetVisibility(points->GetNumberOfPoints() > 0);
}

} // namespace burin
