// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/box.h"
#include "core/geometry/triangle_tree.h"
#include "ui/scene/cut_cover.h"
#include "ui/scene/obstacle_mark.h"
#include "ui/scene/shaded_mesh.h"
#include "ui/theme/theme.h"

#include <vtkActor.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace burin {

/// What an obstacle is drawn with.
struct ObstacleSurface {
    ShadedMesh drawn;
    TriangleTree solid; ///< closed
};
/// Any thread; some tenths of a second for a large one.
ObstacleSurface surfaceOf(const Obstacle& obstacle);

/// What stands around the stock: fixtures as solids, keep-out volumes as films with their edges, either in red while it
/// holds the tool back. Where a fixture hides a cut from the eye it fades, but for its edges, and what is behind it is
/// seen through it. Margins are not drawn. Thread: user interface.
class ObstacleActors {
public:
    using Made = std::function<void(std::shared_ptr<const ObstacleSurface>)>;
    /// Makes the surface of an obstacle somewhere else, and hands it over here.
    using SurfaceMaker = std::function<void(std::shared_ptr<const Obstacle> obstacle, Made then)>;

    /// @param solids draws the workpiece, @param films what is seen through, with the workpiece's depths
    ObstacleActors(vtkRenderer& solids, vtkRenderer& films, SurfaceMaker maker);
    ~ObstacleActors();

    void set(std::vector<ObstacleMark> marks);
    void setPalette(const Palette& palette);
    void setLineWidth(double screenPixels);
    /// Before each paint. @param cuts that are not to be hidden
    void place(std::span<const CutPlace> cuts, const CameraView& view);
    bool filmsVisible() const noexcept; ///< there is something in the films' renderer
    Box box() const;                    ///< of those that are on, mm

private:
    struct Drawn;
    void give(const std::shared_ptr<const Obstacle>& obstacle, const std::shared_ptr<const ObstacleSurface>& surface);
    void dress(const Drawn& drawn) const;

    vtkRenderer &solids_, &films_;
    SurfaceMaker maker_;
    Palette palette_;
    std::vector<std::unique_ptr<Drawn>> drawn_;
    double lineWidth_ = 1.0;
};

} // namespace burin
