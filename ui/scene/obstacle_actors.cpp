// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/obstacle_actors.h"

#include "core/base/units.h"
#include "ui/scene/actors.h"
#include "ui/scene/film_actor.h"
#include "ui/scene/shaded_polydata.h"
#include "ui/theme/colour.h"

#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <algorithm>
#include <utility>

namespace burin {
namespace {

constexpr double obstacleOpacity = 0.12, holdingObstacleOpacity = 0.28, offOpacity = 0.45;
constexpr double holdingShare = 0.35; // of red

void setData(vtkActor& actor, vtkPolyData* data) {
    vtkPolyDataMapper::SafeDownCast(actor.GetMapper())->SetInputData(data);
}

} // namespace

/// One obstacle on the screen; empty until its mesh is there.
struct ObstacleActors::Drawn {
    Drawn(vtkRenderer& solidRenderer, vtkRenderer& filmRenderer, ObstacleMark wanted)
        : solids(solidRenderer), films(filmRenderer), mark(std::move(wanted)) {
        solids.AddActor(solid);
        solids.AddActor(edges);
        films.AddActor(film);
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
    vtkSmartPointer<vtkActor> solid = surfaceActor(vtkNew<vtkPolyData>()),
                              edges = raisedLineActor(vtkNew<vtkPolyData>()), film = filmActor(vtkNew<vtkPolyData>());
};

ObstacleActors::ObstacleActors(vtkRenderer& solids, vtkRenderer& films, Shader shader)
    : solids_(solids), films_(films), shader_(std::move(shader)) {}

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
            shader_(drawn_.back()->mark.obstacle,
                    [this, obstacle = drawn_.back()->mark.obstacle](const std::shared_ptr<const ShadedMesh>& mesh) {
                        give(obstacle, *mesh);
                    });
        }
        dress(*drawn_.back());
    }
}

void ObstacleActors::give(const std::shared_ptr<const Obstacle>& obstacle, const ShadedMesh& mesh) {
    const ShadedPolyData data = polyDataOf(mesh);
    for (const auto& drawn : drawn_) {
        if (drawn->mark.obstacle != obstacle) continue;
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

void ObstacleActors::dress(const Drawn& drawn) const {
    const auto& [obstacle, on, holds] = drawn.mark;
    const bool keepOut = obstacle->kind == ObstacleKind::keepOut;
    drawn.solid->SetVisibility(on && !keepOut);
    drawn.film->SetVisibility(on && keepOut);
    setColour(*drawn.solid, holds ? mixed(palette_.holder, palette_.force, holdingShare) : palette_.holder);
    setColour(*drawn.film, palette_.force);
    drawn.film->GetProperty()->SetOpacity(holds ? holdingObstacleOpacity : obstacleOpacity);
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
        if (drawn->mark.on) box.include(boundsOf(*drawn->mark.obstacle));
    return box;
}

ShadedMesh shadedObstacle(const Obstacle& obstacle) {
    return shaded(meshOf(obstacle), creaseAngle);
}

} // namespace burin
