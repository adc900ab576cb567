// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/part_actors.h"

#include "core/base/units.h"
#include "ui/scene/actors.h"
#include "ui/scene/film_actor.h"
#include "ui/scene/shaded_polydata.h"

#include <vtkMapper.h>
#include <vtkProperty.h>

namespace burin {
namespace {

constexpr std::size_t ghostTriangles = 100'000; // more would cost a hovering pointer its frames
constexpr double ghostOpacity = 0.16, ghostEdgeOpacity = 0.8;
constexpr double edgeOpacity = 0.8;

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
        solids_.RemoveActor(body.surface);
        solids_.RemoveActor(body.edges);
        marks_.RemoveActor(body.ghostSurface);
        marks_.RemoveActor(body.ghostEdges);
    }
    bodies_.clear();
    triangles_ = 0;
    for (ShadedBody& body : bodies) {
        const ShadedPolyData data = polyDataOf(body.mesh);
        triangles_ += body.mesh.triangles.size() / 3;
        bodies_.push_back({surfaceActor(data.surface), raisedLineActor(data.creases, seamHeight - 1.0),
                           glassActor(data.surface), lineActor(data.creases), std::move(body)});
        shadeSimply(*bodies_.back().surface);
        for (vtkActor* actor : {bodies_.back().surface.Get(), bodies_.back().edges.Get()}) clipBy(*actor, clip_);
        solids_.AddActor(bodies_.back().surface);
        solids_.AddActor(bodies_.back().edges);
        marks_.AddActor(bodies_.back().ghostSurface);
        marks_.AddActor(bodies_.back().ghostEdges);
    }
    refresh();
}

void PartActors::setClip(vtkPlane* clip) {
    clip_ = clip;
    for (const Drawn& body : bodies_)
        for (vtkActor* actor : {body.surface.Get(), body.edges.Get()}) clipBy(*actor, clip_);
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

void PartActors::setInWorkpiece(bool drawn) {
    if (drawn == inWorkpiece_) return;
    inWorkpiece_ = drawn;
    refresh();
}

void PartActors::setGhost(bool visible) {
    if (visible == ghost_) return;
    ghost_ = visible;
    refresh();
}

void PartActors::setDepthCue(const DepthCue& cue) {
    for (const Drawn& body : bodies_) burin::setDepthCue(*body.surface, cue);
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
        setColour(*body.surface, inWorkpiece_ ? part_ : body.body.colour.value_or(part_));
        setColour(*body.edges, edges_);
        setBlended(*body.edges, edgeOpacity);
        burin::setLineWidth(*body.edges, lineWidth_);
        body.surface->SetVisibility(drawn() && !covered_);
        body.edges->SetVisibility(drawn());
        setColour(*body.ghostSurface, part_);
        setColour(*body.ghostEdges, part_);
        body.ghostSurface->GetProperty()->SetOpacity(ghostOpacity);
        setBlended(*body.ghostEdges, ghostEdgeOpacity);
        burin::setLineWidth(*body.ghostEdges, lineWidth_);
        body.ghostSurface->SetVisibility(ghost_ && triangles_ <= ghostTriangles);
        body.ghostEdges->SetVisibility(ghost_);
    }
}

} // namespace burin
