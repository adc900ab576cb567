// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/part_actors.h"

#include "core/base/units.h"
#include "ui/scene/actors.h"
#include "ui/scene/shaded_polydata.h"

#include <vtkMapper.h>
#include <vtkProperty.h>

namespace burin {
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
        const ShadedPolyData data = polyDataOf(body.mesh);
        triangles_ += body.mesh.triangles.size() / 3;
        bodies_.push_back({surfaceActor(data.surface), lineActor(data.creases), std::move(body)});
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

void PartActors::setCovered(bool covered) {
    covered_ = covered;
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
        body.surface->SetVisibility(visible_ && !covered_);
        body.edges->SetVisibility(visible_);
    }
}

} // namespace burin
