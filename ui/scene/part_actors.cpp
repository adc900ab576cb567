// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/part_actors.h"

#include "core/base/units.h"
#include "ui/scene/actors.h"
#include "ui/scene/coarse_mesh.h"
#include "ui/scene/film_actor.h"
#include "ui/scene/shaded_polydata.h"
#include "ui/theme/colour.h"

#include <vtkMapper.h>
#include <vtkProperty.h>

#include <utility>

namespace burin {
namespace {

constexpr std::size_t fewTriangles = 5'000;     // of a body: fewer are always drawn in full
constexpr double coarseTolerance = 1e-5;        // fraction of the part's diagonal
constexpr double invisibleError = 0.5;          // pixels
constexpr std::size_t ghostTriangles = 100'000; // more would reduce the frame rate while the pointer hovers
constexpr double ghostOpacity = 0.16, ghostEdgeOpacity = 0.8;
constexpr double edgeOpacity = 0.8;
constexpr double edgeHeight = 0.3; // just above their own faces, so that covering stock hides them

} // namespace

ShadedBody shadedBody(const TriangleMesh& mesh, const std::optional<std::array<std::uint8_t, 3>>& colour,
                      const FaceColours& faces, double crease) {
    ShadedBody body{std::make_shared<const ShadedMesh>(shaded(mesh, crease, faces)), std::nullopt};
    if (colour) body.colour = colourFrom(colour);
    return body;
}

std::vector<ShadedBody> shadedBodies(const Model& model) {
    std::vector<ShadedBody> bodies;
    bodies.reserve(model.bodies.size());
    for (const Body& body : model.bodies) bodies.push_back(shadedBody(body.mesh, body.colour, body.faceColours));
    return bodies;
}

CoarseBodies coarseBodies(const std::vector<ShadedBody>& bodies, double size) {
    CoarseBodies coarse{{}, coarseTolerance * size};
    for (const ShadedBody& body : bodies)
        coarse.surfaces.push_back(body.mesh->triangles.size() / 3 > fewTriangles ? coarsened(*body.mesh, coarse.error)
                                                                                 : nullptr);
    return coarse;
}

void PartActors::setBodies(std::vector<ShadedBody> bodies) {
    for (const Drawn& body : bodies_) {
        eachSolid(body, [&](vtkActor& actor) { solids_.RemoveActor(&actor); });
        marks_.RemoveActor(body.ghostSurface);
        marks_.RemoveActor(body.ghostEdges);
    }
    bodies_.clear();
    triangles_ = 0;
    coarseError_ = 0.0;
    for (ShadedBody& body : bodies) add(std::move(body));
    refresh();
}

void PartActors::add(ShadedBody body) {
    const ShadedPolyData data = polyDataOf(*body.mesh);
    PartCells surface(*data.surface), edges(*data.creases);
    Drawn drawn{{surface, surfaceActor(surface.data())},
                std::nullopt,
                {edges, raisedLineActor(edges.data(), edgeHeight)},
                glassActor(data.surface),
                lineActor(data.creases),
                std::move(body)};
    shadeSimply(*drawn.surface.actor);
    eachSolid(drawn, [&](vtkActor& actor) {
        clipBy(actor, clip_);
        actor.SetUserMatrix(motion_);
        solids_.AddActor(&actor);
    });
    for (vtkActor* ghost : {drawn.ghostSurface.Get(), drawn.ghostEdges.Get()}) ghost->SetUserMatrix(motion_);
    marks_.AddActor(drawn.ghostSurface);
    marks_.AddActor(drawn.ghostEdges);
    triangles_ += drawn.body.mesh->triangles.size() / 3;
    bodies_.push_back(std::move(drawn));
}

void PartActors::setCoarse(const CoarseBodies& coarse) {
    coarseError_ = coarse.error;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        if (coarse.surfaces[i] == nullptr) continue;
        const PartCells cells(*coarse.surfaces[i]);
        Piece& piece = bodies_[i].coarse.emplace(Piece{cells, surfaceActor(cells.data())});
        shadeSimply(*piece.actor);
        clipBy(*piece.actor, clip_);
        piece.actor->SetUserMatrix(motion_);
    }
    drawLast();
    refresh();
}

void PartActors::setClip(vtkPlane* clip) {
    clip_ = clip;
    for (const Drawn& body : bodies_) eachSolid(body, [&](vtkActor& actor) { clipBy(actor, clip_); });
}

void PartActors::setMotion(const Placement& motion) {
    setMatrix(*motion_, motion);
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

void PartActors::setHidden(std::vector<bool> hidden) {
    if (hidden == hidden_) return;
    hidden_ = std::move(hidden);
    refresh();
}

void PartActors::setBodyColours(std::vector<std::optional<QColor>> colours) {
    if (colours == colours_) return;
    colours_ = std::move(colours);
    refresh();
}

QColor PartActors::colourOf(std::size_t body) const {
    if (inWorkpiece_) return part_;
    return (body < colours_.size() ? colours_[body] : bodies_[body].body.colour).value_or(part_);
}

void PartActors::setInWorkpiece(bool drawn) {
    if (drawn == inWorkpiece_) return;
    inWorkpiece_ = drawn;
    refresh();
}

void PartActors::setBare(const std::shared_ptr<const BareBricks>& bare) {
    if (bare == bare_) return;
    bare_ = bare;
    showSolids();
}

void PartActors::drawLast() {
    for (const Drawn& body : bodies_) {
        eachSolid(body, [&](vtkActor& actor) { solids_.RemoveActor(&actor); });
        eachSolid(body, [&](vtkActor& actor) { solids_.AddActor(&actor); });
    }
}

void PartActors::setDetail(bool moving, double pixel) {
    const bool coarse = moving || coarseError_ <= invisibleError * pixel;
    if (coarse == coarse_) return;
    coarse_ = coarse;
    showSolids();
}

void PartActors::showSolids() {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        Drawn& body = bodies_[i];
        if (body.coarse) body.coarse->actor->VisibilityOff();
        body.surface.actor->VisibilityOff();
        show(body.shown(coarse_), drawn() && !covered_ && !hides(i));
        show(body.edges, drawn() && !hides(i));
    }
}

/// Cells are chosen only for what is shown, because choosing is expensive.
void PartActors::show(Piece& piece, bool shown) const {
    if (shown) piece.cells.choose(visible_ ? nullptr : bare_);
    piece.actor->SetVisibility(shown && piece.cells.count() > 0);
}

/// Where the part is drawn in its blue, so are all of its faces.
void PartActors::colour(Piece& piece, const QColor& body) const {
    setColour(*piece.actor, body);
    vtkPolyData& surface = *piece.cells.data();
    if (!hasFaceColours(surface)) return;
    vtkMapper& mapper = *piece.actor->GetMapper();
    mapper.SetScalarVisibility(inWorkpiece_ ? 0 : 1);
    if (inWorkpiece_ || piece.coloured == body) return;
    mapper.SetColorModeToDirectScalars();
    colourFaces(surface, body);
    piece.coloured = body;
}

std::size_t PartActors::triangles() const {
    std::size_t count = 0;
    for (const Drawn& body : bodies_) {
        const Piece& piece = body.shown(coarse_);
        if (piece.actor->GetVisibility() != 0) count += piece.cells.count();
    }
    return count;
}

void PartActors::setGhost(bool visible) {
    if (visible == ghost_) return;
    ghost_ = visible;
    refresh();
}

void PartActors::setDepthCue(const DepthCue& cue) {
    for (const Drawn& body : bodies_) burin::setDepthCue(*body.shown(coarse_).actor, cue);
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
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        if (hides(i)) continue;
        const Drawn& body = bodies_[i];
        const std::optional<double> distance = distanceAlong(*body.body.mesh, sight.origin, sight.direction);
        if (distance && (!nearest || *distance < *nearest)) nearest = distance;
    }
    if (!nearest) return std::nullopt;
    return sight.origin + sight.direction * *nearest;
}

void PartActors::refresh() {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        Drawn& body = bodies_[i];
        const QColor colour = colourOf(i);
        this->colour(body.surface, colour);
        if (body.coarse) this->colour(*body.coarse, colour);
        setColour(*body.edges.actor, edges_);
        setBlended(*body.edges.actor, edgeOpacity);
        burin::setLineWidth(*body.edges.actor, lineWidth_);
        setColour(*body.ghostSurface, part_);
        setColour(*body.ghostEdges, part_);
        body.ghostSurface->GetProperty()->SetOpacity(ghostOpacity);
        setBlended(*body.ghostEdges, ghostEdgeOpacity);
        burin::setLineWidth(*body.ghostEdges, lineWidth_);
        body.ghostSurface->SetVisibility(ghost_ && !hides(i) && triangles_ <= ghostTriangles);
        body.ghostEdges->SetVisibility(ghost_ && !hides(i));
    }
    showSolids();
}

} // namespace burin
