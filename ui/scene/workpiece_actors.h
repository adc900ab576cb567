// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/surface/surface.h"
#include "ui/scene/bare_bricks.h"
#include "ui/scene/excess_colours.h"
#include "ui/scene/view_lights.h"

#include <vtkPlane.h>
#include <vtkRenderer.h>

#include <chrono>
#include <functional>
#include <memory>
#include <optional>

namespace burin {

/// The workpiece in the viewport: meshes changed tiles of the newest snapshot on a worker thread, keeps one actor per
/// group of tiles, and chooses the level of detail. GUI thread, with OpenGL current where VTK needs it.
class WorkpieceActors {
public:
    static constexpr std::size_t movingTriangles = 100'000; ///< maximum drawn while the view or the tool moves

    /// @param ready called when there is something new to draw; must only post a wake-up event. Called on the worker
    ///        thread, and from `update` when one paint can't take everything over
    /// @param solids draws the workpiece, @param films draws translucent surfaces, with the workpiece's depths
    WorkpieceActors(vtkRenderer& solids, vtkRenderer& films, std::function<void()> ready);
    /// Waits for the tile that the worker is processing, some milliseconds; removes the actors from the renderer.
    ~WorkpieceActors();

    /// Replaces the workpiece to show; an empty snapshot: nothing. Returns at once; a snapshot that is superseded
    /// before it is meshed is skipped. For a volume that was shown before, only changes are meshed. Any thread.
    /// @param oldestCut time of the first cut that no earlier snapshot shows
    void show(const VolumeSnapshot& workpiece, std::optional<std::chrono::steady_clock::time_point> oldestCut);
    void setVisible(bool visible);
    /// 0 … 1. Less than 1: what is in it and behind it is visible through its surface.
    void setOpacity(double opacity);
    bool filmsVisible() const noexcept; ///< whether it is drawn by the films' renderer
    /// Draws only what a plane doesn't cut off; null: everything. The plane may be moved.
    void setClip(vtkPlane* clip);
    /// Whether the part's own mesh is drawn as well: bare part is then left out.
    void setPartDrawn(bool drawn);
    /// Sets the sRGB colour of bare part; materials have their own colours.
    void setPartColour(const std::array<std::uint8_t, 3>& colour);
    /// Colours the surface by the stock left on the part; std::nullopt: by material.
    void setExcess(std::optional<ExcessColours> left);
    /// Call before each paint: takes over what the worker has finished, as much as one paint can upload to OpenGL.
    /// @param moving whether view or tool move: then at most `movingTriangles` are drawn, coarser far from the focus
    /// @param focus the point where detail matters most, mm (the tool's tip)
    void update(bool moving, const glm::dvec3& focus);

    /// Sets the depth cue of the surfaces that are currently drawn; call before each paint.
    void setDepthCue(const DepthCue& cue);

    /// Where bare part is left out in the next paint. Null: it may be left out anywhere, since the workpiece isn't
    /// drawn in full.
    const std::shared_ptr<const BareBricks>& bare() const noexcept;
    std::size_t triangles() const; ///< number that the next paint draws
    std::uint64_t volume() const;  ///< number of the volume: when it changes, all actors have been added anew
    bool fullDetail() const;       ///< whether everything is drawn at full detail
    bool busy() const;             ///< whether the worker is not finished
    /// The time of the oldest cut that the next paint shows for the first time; returned only once. (Skipped snapshots
    /// pass theirs on, so that the time from a cut to the screen is never measured too short.)
    std::optional<std::chrono::steady_clock::time_point> takeCutShown();

private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace burin
