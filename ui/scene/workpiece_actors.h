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

/// The workpiece in the viewport: meshes changed tiles of the newest snapshot on a worker thread, keeps an actor a
/// group of tiles, and chooses the level of detail. User interface's thread, OpenGL current where VTK needs it.
class WorkpieceActors {
public:
    static constexpr std::size_t movingTriangles = 100'000; ///< at most drawn while the view or the tool moves

    /// @param ready called when there is something new to draw: post a wake-up, no more. On the worker's thread; and
    ///        from `update` when one paint can't take everything over
    /// @param solids draws the workpiece, @param films what is seen through, with the workpiece's depths
    WorkpieceActors(vtkRenderer& solids, vtkRenderer& films, std::function<void()> ready);
    /// Waits for the tile that the worker is at, some milliseconds; takes the actors out of the renderer.
    ~WorkpieceActors();

    /// Replaces what is to be shown; an empty snapshot: nothing. Returns at once; a snapshot that is overtaken is
    /// skipped. Of a volume that was shown before, only what has changed is meshed. Any thread.
    /// @param oldestCut when the first of those cuts was made that no earlier snapshot shows
    void show(const VolumeSnapshot& workpiece, std::optional<std::chrono::steady_clock::time_point> oldestCut);
    void setVisible(bool visible);
    /// Less than 1: what is in it and behind it is seen through its surface. 0 … 1
    void setOpacity(double opacity);
    bool filmsVisible() const noexcept; ///< it is drawn by the films' renderer
    /// Draws only what a plane doesn't cut off; null: all. The plane may be moved.
    void setClip(vtkPlane* clip);
    /// Whether the part's own mesh is drawn as well: bare part is left out then.
    void setPartDrawn(bool drawn);
    /// sRGB of bare part; materials bring their own colours.
    void setPartColour(const std::array<std::uint8_t, 3>& colour);
    /// Colours by what is left on the part, instead of by material; nothing: by material.
    void setExcess(std::optional<ExcessColours> left);
    /// To be called before each paint: takes over what the worker has ready, as much as one paint can hand to OpenGL.
    /// @param moving whether view or tool move: no more than `movingTriangles` are drawn, coarser far from the focus
    /// @param focus where detail matters most, mm (the tool's tip)
    void update(bool moving, const glm::dvec3& focus);

    /// Of the surfaces that are drawn now, before each paint.
    void setDepthCue(const DepthCue& cue);

    /// Where bare part is left out in the next paint. Null: all of it may be, since the workpiece isn't drawn in full.
    const std::shared_ptr<const BareBricks>& bare() const noexcept;
    std::size_t triangles() const; ///< that the next paint draws
    std::uint64_t volume() const;  ///< counts volumes: with another one, all actors were added anew
    bool fullDetail() const;       ///< everything is drawn at full detail
    bool busy() const;             ///< the worker is not done
    /// Of the cuts that the next paint shows for the first time, the oldest; told once. (Skipped snapshots hand theirs
    /// on, so that a cut's way to the screen is never measured too short.)
    std::optional<std::chrono::steady_clock::time_point> takeCutShown();

private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace burin
