// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/cad/model.h"
#include "core/geometry/pose.h"
#include "core/path/evaluate.h"
#include "core/setup/obstacle.h"
#include "core/tool/tool.h"
#include "core/volume/runs/run_volume.h"
#include "ui/scene/viewport.h"
#include "ui/scene/zero_place.h"
#include "ui/theme/theme.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace burin {

/// Where a picture is cut open; the side that is nearer to the eye comes off.
struct PictureSection {
    int axis = 0;          ///< 0, 1, 2 for x, y, z: the plane is square to it
    double position = 0.0; ///< mm along it, setup frame
};

/// What a picture of the workpiece shows, setup frame, mm.
struct PictureContent {
    VolumeSnapshot workpiece;          ///< not empty
    std::shared_ptr<const Model> part; ///< seen where the workpiece is seen through. Null: none
    std::vector<Obstacle> obstacles;   ///< those that are on are drawn as such
    std::optional<Tool> tool;          ///< standing at `pose`
    ToolPose pose;
    std::vector<std::shared_ptr<const EvaluatedPath>> paths; ///< none is null; the first in the colours of its moves
    std::shared_ptr<const PathValues> values; ///< of the first path, for its colours; null: by kinds of moves
    std::optional<ExcessColours> left;        ///< what the workpiece is coloured by; nothing: by its materials
    StandardView view = StandardView::isometric;
    double opacity = 1.0; ///< of the workpiece, 0 … 1
    std::optional<PictureSection> section;
    std::optional<ZeroPlace> zero;   ///< program zero; nothing: it is not drawn
    Theme theme = Theme::dark;       ///< whose colours it has
    int width = 1600, height = 1000; ///< pixels
};

/// Draws what the window shows of it in full detail. Needs no display, but a QGuiApplication for its letters (on the
/// "offscreen" platform), and is used on its thread alone: an EGL context without a surface (Mesa) is made for it. The
/// workpiece is meshed on a thread of its own, which nothing waits for; between the calls no context is current.
class PictureDrawing {
public:
    /// Some tenths of a second for a large part. Errors: notSupported (no EGL with OpenGL 3.2), those of loadPalette.
    static Result<PictureDrawing> begin(const PictureContent& content);
    ~PictureDrawing();
    PictureDrawing(PictureDrawing&&) noexcept;
    PictureDrawing& operator=(PictureDrawing&&) noexcept;

    /// Takes over what is meshed. Some milliseconds. @return whether all is there
    bool ready();
    void wait(); ///< until all is there
    /// PNG, once it is ready; may be asked for several views. A tenth of a second or two.
    std::string draw(StandardView view);

private:
    class Stage;
    explicit PictureDrawing(std::unique_ptr<Stage> stage);
    std::unique_ptr<Stage> stage_;
};

/// The whole of it at once, waiting for the mesher: some seconds. @return PNG. Errors: those of PictureDrawing::begin.
Result<std::string> drawPicture(const PictureContent& content);

} // namespace burin
