// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/obstacle_actors.h"

#include "core/base/units.h"
#include "ui/scene/actors.h"
#include "ui/scene/film_actor.h"
#include "ui/scene/shaded_polydata.h"
#include "ui/theme/colour.h"

#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace burin {
namespace {

constexpr double obstacleOpacity = 0.12, holdingObstacleOpacity = 0.28, offOpacity = 0.45;
constexpr double holdingShare = 0.35; // fraction of red

void setData(vtkActor& actor, vtkPolyData* data) {
    vtkPolyDataMapper::SafeDownCast(actor.GetMapper())->SetInputData(data);
}

bool isKeptOut(const Obstacle& obstacle) {
    return obstacle.kind == ObstacleKind::keepOut;
}

/// A fixture is drawn like glass when it hides the cut.
vtkSmartPointer<vtkActor> seenThrough(const Obstacle& obstacle) {
    const vtkNew<vtkPolyData> nothing;
    return isKeptOut(obstacle) ? filmActor(nothing) : glassActor(nothing);
}

} // namespace

/// One obstacle on the screen; empty until its mesh is ready.
struct ObstacleActors::Drawn {
    Drawn(vtkRenderer& solidRenderer, vtkRenderer& filmRenderer, ObstacleMark wanted)
        : solids(solidRenderer), films(filmRenderer), mark(std::move(wanted)), film(seenThrough(*mark.obstacle)) {
        solids.AddActor(solid);
        solids.AddActor(edges);
        films.AddActor(film);
        for (vtkActor* actor : {solid.Get(), edges.Get(), film.Get()}) actor->SetUserMatrix(motion);
    }
    ~Drawn() {
        solids.RemoveActor(solid);
        solids.RemoveActor(edges);
        films.RemoveActor(film);
    }
    Drawn(const Drawn&) = delete;
    Drawn& operator=(const Drawn&) = delete;

    vtkRenderer &solids, &films;
    ObstacleMark mark;
    std::shared_ptr<const ObstacleSurface> surface; ///< null until it has been created
    double opacity = 1.0;                           ///< of a fixture
    vtkSmartPointer<vtkActor> solid = surfaceActor(vtkNew<vtkPolyData>()),
                              edges = raisedLineActor(vtkNew<vtkPolyData>()), film;
    vtkNew<vtkMatrix4x4> motion;
};

ObstacleActors::ObstacleActors(vtkRenderer& solids, vtkRenderer& films, SurfaceMaker maker)
    : solids_(solids), films_(films), maker_(std::move(maker)) {}

ObstacleActors::~ObstacleActors() = default;

void ObstacleActors::set(std::vector<ObstacleMark> marks) {
    std::vector<std::unique_ptr<Drawn>> before = std::exchange(drawn_, {});
    for (ObstacleMark& mark : marks) {
        const auto same = std::ranges::find_if(
            before, [&](const auto& drawn) { return drawn && drawn->mark.obstacle == mark.obstacle; });
        if (same != before.end()) {
            drawn_.push_back(std::move(*same));
            drawn_.back()->mark = std::move(mark);
        } else {
            drawn_.push_back(std::make_unique<Drawn>(solids_, films_, std::move(mark)));
            maker_(drawn_.back()->mark.obstacle,
                   [this, obstacle = drawn_.back()->mark.obstacle](const auto& surface) { give(obstacle, surface); });
        }
        dress(*drawn_.back());
    }
}

void ObstacleActors::give(const std::shared_ptr<const Obstacle>& obstacle,
                          const std::shared_ptr<const ObstacleSurface>& surface) {
    const ShadedPolyData data = polyDataOf(surface->drawn);
    for (const auto& drawn : drawn_) {
        if (drawn->mark.obstacle != obstacle) continue;
        drawn->surface = surface;
        setData(*drawn->solid, data.surface);
        setData(*drawn->film, data.surface);
        setData(*drawn->edges, data.creases);
    }
}

void ObstacleActors::setPalette(const Palette& palette) {
    palette_ = palette;
    for (const auto& drawn : drawn_) dress(*drawn);
}

void ObstacleActors::setLineWidth(double screenPixels) {
    lineWidth_ = screenPixels;
    for (const auto& drawn : drawn_) dress(*drawn);
}

void ObstacleActors::place(std::span<const CutPlace> cuts, const CameraView& view) {
    for (const auto& drawn : drawn_) {
        if (!drawn->mark.on || !drawn->surface || isKeptOut(*drawn->mark.obstacle) || !isNone(drawn->mark.moved))
            continue;
        double covered = 0.0;
        for (const CutPlace& cut : cuts) covered = std::max(covered, coveredShare(drawn->surface->solid, cut, view));
        if (std::exchange(drawn->opacity, opacityOver(covered)) != drawn->opacity) dress(*drawn);
    }
}

void ObstacleActors::dress(const Drawn& drawn) const {
    const auto& [obstacle, on, holds, moved] = drawn.mark;
    setMatrix(*drawn.motion, moved);
    const bool keepOut = isKeptOut(*obstacle), faded = drawn.opacity < 1.0;
    const QColor solid = holds ? mixed(palette_.holder, palette_.force, holdingShare) : palette_.holder;
    drawn.solid->SetVisibility(on && !keepOut && !faded);
    drawn.film->SetVisibility(on && (keepOut || faded));
    setColour(*drawn.solid, solid);
    setColour(*drawn.film, keepOut ? palette_.force : solid);
    drawn.film->GetProperty()->SetOpacity(!keepOut ? drawn.opacity : holds ? holdingObstacleOpacity : obstacleOpacity);
    setColour(*drawn.edges, keepOut || holds ? palette_.force : palette_.quietText);
    setBlended(*drawn.edges, on ? 1.0 : offOpacity);
    burin::setLineWidth(*drawn.edges, lineWidth_ * (holds ? boldLine : thinLine));
}

bool ObstacleActors::filmsVisible() const noexcept {
    return std::ranges::any_of(drawn_, [](const auto& drawn) { return drawn->film->GetVisibility() != 0; });
}

Box ObstacleActors::box() const {
    Box box;
    for (const auto& drawn : drawn_)
        if (drawn->mark.on) box.include(boxAround(boundsOf(*drawn->mark.obstacle), drawn->mark.moved));
    return box;
}

ObstacleSurface surfaceOf(const Obstacle& obstacle) {
    const TriangleMesh mesh = meshOf(obstacle);
    std::vector<std::uint32_t> all(mesh.triangles.size());
    std::iota(all.begin(), all.end(), 0U);
    return {shaded(mesh, creaseAngle), TriangleTree(mesh, all)};
}

} // namespace burin
