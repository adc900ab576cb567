// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/part_actors.h"

#include "core/base/units.h"
#include "ui/scene/actors.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkMapper.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkProperty.h>
#include <vtkTypeInt32Array.h>

#include <algorithm>

namespace burin {
namespace {

constexpr double creaseAngle = 25.0 * pi / 180.0;

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

std::vector<ShadedBody> shadedBodies(const Model& model) {
    std::vector<ShadedBody> bodies;
    bodies.reserve(model.bodies.size());
    for (const Body& body : model.bodies) {
        ShadedBody drawn{shaded(body.mesh, creaseAngle), std::nullopt};
        if (body.colour) drawn.colour = QColor((*body.colour)[0], (*body.colour)[1], (*body.colour)[2]);
        bodies.push_back(std::move(drawn));
    }
    return bodies;
}

void PartActors::setBodies(std::vector<ShadedBody> bodies) {
    for (const Drawn& body : bodies_) {
        renderer_.RemoveActor(body.surface);
        renderer_.RemoveActor(body.edges);
    }
    bodies_.clear();
    triangles_ = 0;
    for (ShadedBody& body : bodies) {
        vtkNew<vtkPoints> points;
        points->SetData(floats(body.mesh.points));
        vtkNew<vtkPolyData> surface;
        surface->SetPoints(points);
        surface->GetPointData()->SetNormals(floats(body.mesh.normals));
        surface->SetPolys(cells(body.mesh.triangles, 3));
        vtkNew<vtkPolyData> edges;
        edges->SetPoints(points);
        edges->SetLines(cells(body.mesh.creases, 2));
        triangles_ += body.mesh.triangles.size() / 3;
        bodies_.push_back({surfaceActor(surface), lineActor(edges), std::move(body)});
        renderer_.AddActor(bodies_.back().surface);
        renderer_.AddActor(bodies_.back().edges);
    }
    refresh();
}

void PartActors::setColours(const QColor& part, const QColor& edges) {
    part_ = part;
    edges_ = edges;
    refresh();
}

void PartActors::setVisible(bool visible) {
    visible_ = visible;
    refresh();
}

void PartActors::setLineWidth(double screenPixels) {
    lineWidth_ = screenPixels;
    refresh();
}

std::optional<glm::dvec3> PartActors::pick(const Sight& sight) const {
    if (!visible_) return std::nullopt;
    std::optional<double> nearest;
    for (const Drawn& body : bodies_) {
        const std::optional<double> distance = distanceAlong(body.body.mesh, sight.origin, sight.direction);
        if (distance && (!nearest || *distance < *nearest)) nearest = distance;
    }
    if (!nearest) return std::nullopt;
    return sight.origin + sight.direction * *nearest;
}

void PartActors::refresh() {
    for (const Drawn& body : bodies_) {
        setColour(*body.surface, body.body.colour.value_or(part_));
        setColour(*body.edges, edges_);
        setBlended(*body.edges, 0.45);
        burin::setLineWidth(*body.edges, lineWidth_);
        body.surface->SetVisibility(visible_);
        body.edges->SetVisibility(visible_);
    }
}

} // namespace burin
