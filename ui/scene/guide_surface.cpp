// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/guide_surface.h"

#include "ui/scene/round_spacing.h"

#include <vtkCellArray.h>
#include <vtkCutter.h>
#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace burin {
namespace {

constexpr int newtonSteps = 4;
constexpr double onIt = 0.01; // fraction of the field's cell
constexpr double usableGradient = 0.2;

/// The field minus the distance, sampled on a grid. Beyond the fine band only the sign matters.
vtkSmartPointer<vtkImageData> sampled(const ClearanceField& field, const Box& tips, double distance) {
    const glm::dvec3 size = tips.size();
    const double cell = std::max({size.x, size.y, size.z}) / guideSurfaceCells;
    const glm::ivec3 count = glm::ivec3(glm::ceil(size / cell)) + 1;
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(count.x, count.y, count.z);
    image->SetOrigin(tips.low.x, tips.low.y, tips.low.z);
    image->SetSpacing(cell, cell, cell);
    image->AllocateScalars(VTK_FLOAT, 1);
    auto* value = vtkFloatArray::SafeDownCast(image->GetPointData()->GetScalars());
    vtkIdType next = 0;
    for (int z = 0; z < count.z; ++z)
        for (int y = 0; y < count.y; ++y)
            for (int x = 0; x < count.x; ++x) {
                const FieldSample sample = field.at(tips.low + cell * glm::dvec3(x, y, z));
                const double off = sample.fine              ? sample.clearance - distance
                                   : sample.clearance > 0.0 ? std::max(cell, sample.clearance - distance)
                                                            : -cell;
                value->SetValue(next++, static_cast<float>(off));
            }
    return image;
}

/// Moves a corner onto the surface. Returns false if there is none near it.
bool settle(const ClearanceField& field, double distance, double reach, glm::dvec3& place) {
    const glm::dvec3 start = place;
    for (int step = 0; step < newtonSteps; ++step) {
        const FieldSample sample = field.at(place);
        const double square = glm::dot(sample.gradient, sample.gradient);
        if (!sample.fine || square < usableGradient * usableGradient) return false;
        const double off = sample.clearance - distance;
        if (std::abs(off) <= onIt * field.spacing()) return true;
        place -= sample.gradient * (off / square);
        if (glm::distance(place, start) > reach) return false;
    }
    // At a crease of the field the last step may oscillate; half a cell is the accuracy that can be reached there.
    return std::abs(field.at(place).clearance - distance) <= 0.5 * field.spacing();
}

/// The triangles whose corners are all on the surface.
vtkSmartPointer<vtkPolyData> settled(const ClearanceField& field, double distance, double reach, vtkPolyData& raw) {
    vtkPoints& points = *raw.GetPoints();
    std::vector<bool> good(static_cast<std::size_t>(points.GetNumberOfPoints()));
    for (vtkIdType i = 0; i < points.GetNumberOfPoints(); ++i) {
        std::array<double, 3> p{};
        points.GetPoint(i, p.data());
        glm::dvec3 place(p[0], p[1], p[2]);
        good[static_cast<std::size_t>(i)] = settle(field, distance, reach, place);
        points.SetPoint(i, place.x, place.y, place.z);
    }
    vtkNew<vtkCellArray> kept;
    vtkNew<vtkIdList> corners;
    for (raw.GetPolys()->InitTraversal(); raw.GetPolys()->GetNextCell(corners) != 0;)
        if (std::all_of(corners->begin(), corners->end(),
                        [&](vtkIdType corner) { return good[static_cast<std::size_t>(corner)]; }))
            kept->InsertNextCell(corners);
    auto shell = vtkSmartPointer<vtkPolyData>::New();
    shell->SetPoints(&points);
    shell->SetPolys(kept);
    return shell;
}

/// Lines on a shell at round heights.
vtkSmartPointer<vtkPolyData> contoursOf(vtkPolyData& shell, const Box& tips) {
    const glm::dvec3 size = tips.size();
    const double spacing = roundSpacing(std::max({size.x, size.y, size.z}));
    vtkNew<vtkPlane> level;
    level->SetOrigin(0.0, 0.0, 0.0);
    level->SetNormal(0.0, 0.0, 1.0);
    vtkNew<vtkCutter> cutter;
    cutter->SetCutFunction(level);
    cutter->SetInputData(&shell);
    const double first = std::ceil(tips.low.z / spacing), last = std::floor(tips.high.z / spacing);
    const int count = static_cast<int>(last - first) + 1;
    if (count > 0) cutter->GenerateValues(count, first * spacing, last * spacing);
    cutter->Update();
    auto lines = vtkSmartPointer<vtkPolyData>::New();
    lines->SetPoints(cutter->GetOutput()->GetPoints());
    lines->SetLines(cutter->GetOutput()->GetLines());
    return lines;
}

} // namespace

GuideSurface guideSurface(const ClearanceField& field, const Box& tips, double distance) {
    vtkNew<vtkFlyingEdges3D> contour;
    const vtkSmartPointer<vtkImageData> image = sampled(field, tips, distance);
    contour->SetInputData(image);
    contour->SetValue(0, 0.0);
    contour->ComputeNormalsOff();
    contour->ComputeScalarsOff();
    contour->Update();
    GuideSurface surface;
    if (contour->GetOutput()->GetNumberOfPolys() == 0) {
        surface.shell = surface.contours = vtkSmartPointer<vtkPolyData>::New();
        return surface;
    }
    const double reach = 2.0 * image->GetSpacing()[0];
    surface.shell = settled(field, distance, reach, *contour->GetOutput());
    surface.contours = contoursOf(*surface.shell, tips);
    return surface;
}

} // namespace burin
