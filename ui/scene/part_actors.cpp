// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/part_actors.h"

#include "core/base/units.h"
#include "ui/scene/actors.h"
#include "ui/scene/coarse_mesh.h"
#include "ui/scene/film_actor.h"
#include "ui/scene/shaded_polydata.h"

#include <vtkMapper.h>
#include <vtkProperty.h>

#include <algorithm>

namespace burin {
namespace {

constexpr std::size_t fewTriangles = 5'000;     // of a body: always drawn in full
constexpr double coarseTolerance = 1e-5;        // of the part's diagonal
constexpr double invisibleError = 0.5;          // pixels
constexpr std::size_t ghostTriangles = 100'000; // more would cost a hovering pointer its frames
constexpr double ghostOpacity = 0.16, ghostEdgeOpacity = 0.8;
constexpr double edgeOpacity = 0.8;
constexpr double edgeHeight = 0.3; // just above their own faces: not through stock that covers them

} // namespace

std::vector<ShadedBody> shadedBodies(const Model& model) {
    std::vector<ShadedBody> bodies;
    bodies.reserve(model.bodies.size());
    for (const Body& body : model.bodies) {
        ShadedBody drawn{shaded(body.mesh, creaseAngle), {}, 0.0, std::nullopt};
        if (body.mesh.triangles.size() > fewTriangles) {
            drawn.coarseError = coarseTolerance * glm::length(model.box().size());
            drawn.coarse = coarsened(drawn.mesh, drawn.coarseError);
        }
        if (body.colour) drawn.colour = QColor((*body.colour)[0], (*body.colour)[1], (*body.colour)[2]);
        bodies.push_back(std::move(drawn));
    }
    return bodies;
}

void PartActors::setBodies(std::vector<ShadedBody> bodies) {
    for (const Drawn& body : bodies_) {
        solids_.RemoveActor(body.surface);
        solids_.RemoveActor(body.coarse);
        solids_.RemoveActor(body.edges);
        marks_.RemoveActor(body.ghostSurface);
        marks_.RemoveActor(body.ghostEdges);
    }
    bodies_.clear();
    triangles_ = coarseTriangles_ = 0;
    for (ShadedBody& body : bodies) add(std::move(body));
    refresh();
}

void PartActors::add(ShadedBody body) {
    const ShadedPolyData data = polyDataOf(body.mesh);
    Drawn drawn{surfaceActor(data.surface),
                {},
                raisedLineActor(data.creases, edgeHeight),
                glassActor(data.surface),
                lineActor(data.creases),
                std::move(body)};
    const ShadedMesh& coarse = drawn.body.coarse;
    drawn.coarse = coarse.triangles.empty() ? drawn.surface : surfaceActor(polyDataOf(coarse).surface);
    triangles_ += drawn.body.mesh.triangles.size() / 3;
    coarseTriangles_ += (coarse.triangles.empty() ? drawn.body.mesh : coarse).triangles.size() / 3;
    shadeSimply(*drawn.surface);
    if (drawn.coarse != drawn.surface) shadeSimply(*drawn.coarse);
    for (vtkActor* actor : {drawn.surface.Get(), drawn.coarse.Get(), drawn.edges.Get()}) {
        clipBy(*actor, clip_);
        solids_.AddActor(actor); // one that is there already is not added again
    }
    marks_.AddActor(drawn.ghostSurface);
    marks_.AddActor(drawn.ghostEdges);
    bodies_.push_back(std::move(drawn));
}

void PartActors::setClip(vtkPlane* clip) {
    clip_ = clip;
    for (const Drawn& body : bodies_)
        for (vtkActor* actor : {body.surface.Get(), body.coarse.Get(), body.edges.Get()}) clipBy(*actor, clip_);
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

void PartActors::drawLast() {
    for (const Drawn& body : bodies_) {
        for (vtkActor* actor : {body.surface.Get(), body.coarse.Get(), body.edges.Get()}) solids_.RemoveActor(actor);
        for (vtkActor* actor : {body.surface.Get(), body.coarse.Get(), body.edges.Get()}) solids_.AddActor(actor);
    }
}

void PartActors::setDetail(bool moving, double pixel) {
    double error = 0.0;
    for (const Drawn& body : bodies_) error = std::max(error, body.body.coarseError);
    const bool coarse = moving || error <= invisibleError * pixel;
    if (coarse == coarse_) return;
    coarse_ = coarse;
    showSurfaces();
}

void PartActors::showSurfaces() {
    const bool shown = drawn() && !covered_;
    for (const Drawn& body : bodies_) {
        body.surface->SetVisibility(shown && !coarse_);
        if (coarse_ || body.coarse != body.surface) body.coarse->SetVisibility(shown && coarse_);
    }
}

void PartActors::setGhost(bool visible) {
    if (visible == ghost_) return;
    ghost_ = visible;
    refresh();
}

void PartActors::setDepthCue(const DepthCue& cue) {
    for (const Drawn& body : bodies_) burin::setDepthCue(coarse_ ? *body.coarse : *body.surface, cue);
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
        for (vtkActor* surface : {body.surface.Get(), body.coarse.Get()})
            setColour(*surface, inWorkpiece_ ? part_ : body.body.colour.value_or(part_));
        setColour(*body.edges, edges_);
        setBlended(*body.edges, edgeOpacity);
        burin::setLineWidth(*body.edges, lineWidth_);
        body.edges->SetVisibility(drawn());
        setColour(*body.ghostSurface, part_);
        setColour(*body.ghostEdges, part_);
        body.ghostSurface->GetProperty()->SetOpacity(ghostOpacity);
        setBlended(*body.ghostEdges, ghostEdgeOpacity);
        burin::setLineWidth(*body.ghostEdges, lineWidth_);
        body.ghostSurface->SetVisibility(ghost_ && triangles_ <= ghostTriangles);
        body.ghostEdges->SetVisibility(ghost_);
    }
    showSurfaces();
}

} // namespace burin
