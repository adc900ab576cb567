// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/tool_surface.h"

#include "core/base/units.h"
#include "core/tool/tool_solid.h"

#include <vtkAppendPolyData.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyDataNormals.h>
#include <vtkRotationalExtrusionFilter.h>

#include <algorithm>
#include <cmath>

namespace burin {

vtkSmartPointer<vtkPolyData> pieceSurface(const RevolvedPiece& piece) {
    vtkNew<vtkPoints> points;
    points->InsertNextPoint(0.0, 0.0, piece.bottom);
    constexpr int arcSteps = 16;
    const double corner = piece.cornerRadius;
    for (int i = 0; i <= arcSteps && corner > 0.0; ++i) {
        const double angle = 0.5 * pi * i / arcSteps;
        points->InsertNextPoint(piece.bottomRadius - corner + corner * std::sin(angle), 0.0,
                                piece.bottom + corner - corner * std::cos(angle));
    }
    if (corner <= 0.0) points->InsertNextPoint(piece.bottomRadius, 0.0, piece.bottom);
    if (piece.bulges()) {
        const auto angleAt = [&](double height) {
            return std::asin(std::clamp((height - piece.bulgeCentreHeight) / piece.bulgeRadius, -1.0, 1.0));
        };
        const double low = angleAt(piece.bottom), high = angleAt(piece.top);
        for (int i = 1; i < 2 * arcSteps; ++i) {
            const double angle = low + (high - low) * i / (2 * arcSteps);
            points->InsertNextPoint(piece.bulgeCentreRadius + piece.bulgeRadius * std::cos(angle), 0.0,
                                    piece.bulgeCentreHeight + piece.bulgeRadius * std::sin(angle));
        }
    }
    points->InsertNextPoint(piece.topRadius, 0.0, piece.top);
    points->InsertNextPoint(0.0, 0.0, piece.top);

    vtkNew<vtkCellArray> line;
    line->InsertNextCell(static_cast<int>(points->GetNumberOfPoints()));
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i) line->InsertCellPoint(i);
    vtkNew<vtkPolyData> profile;
    profile->SetPoints(points);
    profile->SetLines(line);

    vtkNew<vtkRotationalExtrusionFilter> revolve;
    revolve->SetInputData(profile);
    revolve->SetResolution(64);
    revolve->CappingOff();
    vtkNew<vtkPolyDataNormals> normals;
    normals->SetInputConnection(revolve->GetOutputPort());
    normals->SetFeatureAngle(40.0);
    normals->Update();
    return normals->GetOutput();
}

vtkSmartPointer<vtkPolyData> meshSurface(const TriangleMesh& mesh) {
    vtkNew<vtkPoints> points;
    for (const glm::dvec3& vertex : mesh.vertices) points->InsertNextPoint(vertex.x, vertex.y, vertex.z);
    vtkNew<vtkCellArray> triangles;
    for (const auto& triangle : mesh.triangles) {
        triangles->InsertNextCell(3);
        for (const std::uint32_t vertex : triangle) triangles->InsertCellPoint(vertex);
    }
    vtkNew<vtkPolyData> surface;
    surface->SetPoints(points);
    surface->SetPolys(triangles);
    vtkNew<vtkPolyDataNormals> normals;
    normals->SetInputData(surface);
    normals->SetFeatureAngle(40.0);
    normals->Update();
    return normals->GetOutput();
}

vtkSmartPointer<vtkPolyData> flutesSurface(const Cutter& cutter) {
    if (cutter.solid != nullptr) return meshSurface(turnedAboutAxis(cutter.solid->flutes, cutter.solid->angle));
    vtkNew<vtkAppendPolyData> all;
    for (const RevolvedPiece& piece : flutePieces(cutter)) all->AddInputData(pieceSurface(piece));
    all->Update();
    return all->GetOutput();
}

} // namespace burin
