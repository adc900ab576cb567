// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/workpiece_polydata.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkTypeInt32Array.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <vector>

namespace burin {

namespace {

/// Writes the vertices of a mesh and its skirt, one after the other.
class PointWriter {
public:
    explicit PointWriter(std::size_t count) {
        const auto tuples = static_cast<vtkIdType>(count);
        for (vtkFloatArray* array : {places_.Get(), normals_.Get()}) {
            array->SetNumberOfComponents(3);
            array->SetNumberOfTuples(tuples);
        }
        normals_->SetName("normal");
        colours_->SetName("colour");
        colours_->SetNumberOfComponents(3);
        colours_->SetNumberOfTuples(tuples);
    }
    void add(const glm::vec3& place, const glm::vec3& normal, const RgbColour& colour) {
        places_->SetTypedTuple(next_, &place.x);
        normals_->SetTypedTuple(next_, &normal.x);
        colours_->SetTypedTuple(next_, colour.data());
        ++next_;
    }
    void giveTo(vtkPolyData& data) {
        vtkNew<vtkPoints> points;
        points->SetData(places_);
        data.SetPoints(points);
        data.GetPointData()->SetNormals(normals_);
        data.GetPointData()->SetScalars(colours_);
    }

private:
    vtkNew<vtkFloatArray> places_, normals_;
    vtkNew<vtkUnsignedCharArray> colours_;
    vtkIdType next_ = 0;
};

vtkSmartPointer<vtkCellArray> triangleCells(std::span<const std::uint32_t> triangles, std::size_t firstSkirtPoint,
                                            std::span<const std::uint32_t> rim) {
    const std::size_t count = triangles.size() / 3 + rim.size();
    vtkNew<vtkTypeInt32Array> offsets, corners;
    offsets->SetNumberOfValues(static_cast<vtkIdType>(count) + 1);
    corners->SetNumberOfValues(static_cast<vtkIdType>(count) * 3);
    for (std::size_t i = 0; i <= count; ++i)
        offsets->SetValue(static_cast<vtkIdType>(i), static_cast<vtkTypeInt32>(3 * i));
    vtkTypeInt32* next = std::transform(triangles.begin(), triangles.end(), corners->GetPointer(0),
                                        [](std::uint32_t corner) { return static_cast<vtkTypeInt32>(corner); });
    for (std::size_t i = 0; i < rim.size(); i += 2) {
        const auto from = static_cast<vtkTypeInt32>(rim[i]), to = static_cast<vtkTypeInt32>(rim[i + 1]);
        const auto deepFrom = static_cast<vtkTypeInt32>(firstSkirtPoint + i), deepTo = deepFrom + 1;
        for (const vtkTypeInt32 corner : {to, from, deepFrom, to, deepFrom, deepTo}) *next++ = corner;
    }
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    cells->SetData(offsets, corners);
    return cells;
}

/// The lower end of the skirt below each point of the rim.
std::vector<glm::vec3> skirtEnds(const SurfaceMesh& mesh, std::span<const std::uint32_t> rim,
                                 std::span<const float> depths) {
    std::vector<glm::vec3> beyond(rim.empty() ? 0 : mesh.points.size(), glm::vec3(0.0F));
    for (std::size_t i = 0; i < rim.size(); i += 2) {
        const glm::vec3 along = mesh.points[rim[i + 1]] - mesh.points[rim[i]];
        for (const std::uint32_t point : {rim[i], rim[i + 1]}) beyond[point] += glm::cross(along, mesh.normals[point]);
    }
    std::vector<glm::vec3> ends;
    for (std::size_t i = 0; i < rim.size(); ++i) {
        const std::uint32_t point = rim[i];
        const float length = glm::length(beyond[point]);
        const glm::vec3 out = length > 0.0F ? beyond[point] / (3.0F * length) : glm::vec3(0.0F);
        ends.push_back(mesh.points[point] + depths[i] * (out - mesh.normals[point]));
    }
    return ends;
}

} // namespace

std::vector<RgbColour> colourByMaterial(const SurfaceMesh& mesh, const PropertyList& properties,
                                        const RgbColour& partColour) {
    std::vector<RgbColour> colours;
    colours.reserve(mesh.properties.size());
    for (const PropertyIndex property : mesh.properties)
        colours.push_back(properties.isProtected(property) ? partColour : properties[property].colour);
    return colours;
}

vtkSmartPointer<vtkPolyData> surfacePolyData(const SurfaceMesh& mesh, std::span<const RgbColour> colours,
                                             std::span<const std::uint32_t> rim, std::span<const float> skirt) {
    PointWriter writer(mesh.points.size() + rim.size());
    for (std::size_t i = 0; i < mesh.points.size(); ++i) writer.add(mesh.points[i], mesh.normals[i], colours[i]);
    const std::vector<glm::vec3> ends = skirtEnds(mesh, rim, skirt);
    for (std::size_t i = 0; i < rim.size(); ++i) writer.add(ends[i], mesh.normals[rim[i]], colours[rim[i]]);
    auto data = vtkSmartPointer<vtkPolyData>::New();
    writer.giveTo(*data);
    data->SetPolys(triangleCells(mesh.triangles, mesh.points.size(), rim));
    data->ComputeBounds(); // computed here, so that the GUI thread need not do it
    return data;
}

} // namespace burin
