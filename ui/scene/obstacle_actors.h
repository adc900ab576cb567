// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/box.h"
#include "ui/scene/obstacle_mark.h"
#include "ui/scene/shaded_mesh.h"
#include "ui/theme/theme.h"

#include <vtkActor.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <functional>
#include <vector>

namespace burin {

/// What stands around the stock: fixtures as solids, keep-out volumes as films with their edges, either in red while it
/// holds the tool back. Margins are not drawn. Thread: user interface.
class ObstacleActors {
public:
    using Shaded = std::function<void(std::shared_ptr<const ShadedMesh>)>;
    /// Makes the mesh that an obstacle is drawn with somewhere else, and hands it over here.
    using Shader = std::function<void(std::shared_ptr<const Obstacle> obstacle, Shaded then)>;

    /// @param solids draws the bench, @param films what is seen through, with the bench's depths
    ObstacleActors(vtkRenderer& solids, vtkRenderer& films, Shader shader);
    ~ObstacleActors();

    void set(std::vector<ObstacleMark> marks);
    void setPalette(const Palette& palette);
    void setLineWidth(double screenPixels);
    bool filmsVisible() const noexcept; ///< there is something in the films' renderer
    Box box() const;                    ///< of those that are on, mm

private:
    struct Drawn;
    void give(const std::shared_ptr<const Obstacle>& obstacle, const ShadedMesh& mesh);
    void dress(const Drawn& drawn) const;

    vtkRenderer &solids_, &films_;
    Shader shader_;
    Palette palette_;
    std::vector<std::unique_ptr<Drawn>> drawn_;
    double lineWidth_ = 1.0;
};

/// The mesh that an obstacle is drawn with. Any thread; some tenths of a second for a large one.
ShadedMesh shadedObstacle(const Obstacle& obstacle);

} // namespace burin
