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

/// The surface of an obstacle.
struct ObstacleSurface {
    ShadedMesh drawn;
    TriangleTree solid; ///< closed
};
/// Any thread; takes some tenths of a second for a large obstacle.
ObstacleSurface surfaceOf(const Obstacle& obstacle);

/// The obstacles around the stock: fixtures as solids, keep-out volumes as translucent surfaces with their edges,
/// tinted red while they hold the tool back. A fixture that hides a cut from the eye fades, except for its edges, so
/// that what is behind it becomes visible. Clearance margins are not drawn. GUI thread.
class ObstacleActors {
public:
    using Made = std::function<void(std::shared_ptr<const ObstacleSurface>)>;
    /// Creates the surface of an obstacle asynchronously and passes it to `then` on the GUI thread.
    using SurfaceMaker = std::function<void(std::shared_ptr<const Obstacle> obstacle, Made then)>;

    /// @param solids draws the workpiece, @param films draws translucent surfaces, with the workpiece's depths
    ObstacleActors(vtkRenderer& solids, vtkRenderer& films, SurfaceMaker maker);
    ~ObstacleActors();

    void set(std::vector<ObstacleMark> marks);
    void setPalette(const Palette& palette);
    void setLineWidth(double screenPixels);
    /// Call before each paint. @param cuts positions that must not be hidden
    void place(std::span<const CutPlace> cuts, const CameraView& view);
    bool filmsVisible() const noexcept; ///< whether there is something in the films' renderer
    Box box() const;                    ///< bounding box of the obstacles that are on, mm

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
