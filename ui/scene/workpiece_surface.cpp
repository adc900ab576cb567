// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/workpiece_surface.h"

#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyDataNormals.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowedSincPolyDataFilter.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace burin {

namespace {

/// The part where it is bare, whatever it is made of: nothing else on the bench is blue.
constexpr std::array<std::uint8_t, 3> partColour{74, 144, 217};

/// How full the voxels are, 0 … 1, with a rim of empty voxels so that the surface closes.
vtkSmartPointer<vtkImageData> fullness(const VolumeSnapshot& workpiece) {
    const Grid& grid = workpiece.grid();
    const glm::ivec3 size = grid.count() + 2;
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(size.x, size.y, size.z);
    image->SetSpacing(grid.edge(), grid.edge(), grid.edge());
    const glm::dvec3 origin = grid.low() - glm::dvec3(0.5 * grid.edge()); // values stand at voxel centres
    image->SetOrigin(origin.x, origin.y, origin.z);
    image->AllocateScalars(VTK_FLOAT, 1);
    auto* values = static_cast<float*>(image->GetScalarPointer());
    std::fill_n(values,
                static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) * static_cast<std::size_t>(size.z),
                0.0F);

    for (std::int32_t v = 0; v < grid.lineCountV(); ++v)
        for (std::int32_t u = 0; u < grid.lineCountU(); ++u) {
            RunPosition begin = 0;
            for (const Segment segment : workpiece.line({u, v})) {
                const RunPosition end = segment.end();
                for (RunPosition at = begin; segment.property() != airProperty && at < end;) {
                    const RunPosition voxel = at / unitsPerVoxel;
                    const RunPosition next = std::min(end, (voxel + 1) * unitsPerVoxel);
                    const VoxelIndex index = grid.voxel({u, v}, static_cast<std::int32_t>(voxel));
                    const auto place = static_cast<std::size_t>(index.i + 1) +
                                       static_cast<std::size_t>(size.x) *
                                           (static_cast<std::size_t>(index.j + 1) +
                                            static_cast<std::size_t>(size.y) * static_cast<std::size_t>(index.k + 1));
                    values[place] += static_cast<float>(next - at) / unitsPerVoxel;
                    at = next;
                }
                begin = end;
            }
        }
    return image;
}

PropertyIndex propertyAt(const VolumeSnapshot& workpiece, const glm::dvec3& place) {
    const Grid& grid = workpiece.grid();
    const glm::ivec3 index =
        glm::clamp(glm::ivec3(glm::floor((place - grid.low()) / grid.edge())), glm::ivec3(0), grid.count() - 1);
    const VoxelIndex voxel{index.x, index.y, index.z};
    const RunPosition position = grid.toRunPosition(place[grid.axisOfRuns()]);
    for (const Segment segment : workpiece.line(grid.lineOf(voxel)))
        if (position < segment.end()) return segment.property();
    return airProperty;
}

/// Material under a point of the surface: the part where it lies within a voxel (a finishing pass leaves a film of
/// some hundredths of a millimetre, which nobody would call stock), else the first that is not air on the way in.
PropertyIndex propertyUnder(const VolumeSnapshot& workpiece, const glm::dvec3& place, const glm::dvec3& normal) {
    PropertyIndex found = airProperty;
    for (const double depth : {0.3, 0.6, 0.9, 1.3, 1.8}) {
        const PropertyIndex property = propertyAt(workpiece, place - normal * (depth * workpiece.grid().edge()));
        if (depth < 1.0 && workpiece.properties().isProtected(property)) return property;
        if (found == airProperty) found = property;
    }
    return found;
}

void addColours(vtkPolyData& surface, const VolumeSnapshot& workpiece) {
    vtkNew<vtkUnsignedCharArray> colours;
    colours->SetName("colour");
    colours->SetNumberOfComponents(3);
    colours->SetNumberOfTuples(surface.GetNumberOfPoints());
    vtkDataArray* pointNormals = surface.GetPointData()->GetNormals();
    for (vtkIdType point = 0; point < surface.GetNumberOfPoints(); ++point) {
        glm::dvec3 place(0.0), normal(0.0);
        surface.GetPoint(point, &place.x);
        pointNormals->GetTuple(point, &normal.x);
        const PropertyIndex property = propertyUnder(workpiece, place, normal);
        const bool bare = workpiece.properties().isProtected(property);
        colours->SetTypedTuple(point, bare ? partColour.data() : workpiece.properties()[property].colour.data());
    }
    surface.GetPointData()->SetScalars(colours);
}

} // namespace

vtkSmartPointer<vtkPolyData> workpieceSurface(const VolumeSnapshot& workpiece) {
    vtkNew<vtkFlyingEdges3D> contour;
    contour->SetInputData(fullness(workpiece));
    contour->SetValue(0, 0.5);
    contour->ComputeNormalsOff();
    contour->ComputeGradientsOff();
    contour->ComputeScalarsOff();
    // Across the runs a wall is known to a voxel only: what is drawn is relaxed within it, the volume is not touched.
    vtkNew<vtkWindowedSincPolyDataFilter> relaxed;
    relaxed->SetInputConnection(contour->GetOutputPort());
    relaxed->SetNumberOfIterations(12);
    relaxed->SetPassBand(0.08);
    relaxed->BoundarySmoothingOff();
    relaxed->FeatureEdgeSmoothingOff();
    relaxed->NonManifoldSmoothingOn();
    relaxed->NormalizeCoordinatesOn();
    vtkNew<vtkPolyDataNormals> normals;
    normals->SetInputConnection(relaxed->GetOutputPort());
    normals->SplittingOff();
    normals->ConsistencyOff();
    normals->Update();
    vtkSmartPointer<vtkPolyData> surface = normals->GetOutput();
    addColours(*surface, workpiece);
    return surface;
}

} // namespace burin
