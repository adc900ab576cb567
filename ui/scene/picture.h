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

/// The section plane of a picture; the side nearer to the eye is removed.
struct PictureSection {
    int axis = 0;          ///< 0, 1, 2 for x, y, z: normal of the plane
    double position = 0.0; ///< mm along it, setup frame
};

/// The content of a picture of the workpiece, setup frame, mm.
struct PictureContent {
    VolumeSnapshot workpiece;          ///< not empty
    std::shared_ptr<const Model> part; ///< visible where the workpiece is transparent; null: none
    std::vector<Obstacle> obstacles;   ///< those that are on are drawn as such
    std::optional<Tool> tool;          ///< drawn at `pose`
    ToolPose pose;
    std::vector<std::shared_ptr<const EvaluatedPath>> paths; ///< never null; the first one in the colours of its moves
    std::shared_ptr<const PathValues> values; ///< of the first path, for its colours; null: coloured by kind of move
    std::optional<ExcessColours> left;        ///< colouring of the workpiece; empty: by its materials
    StandardView view = StandardView::isometric;
    double opacity = 1.0; ///< of the workpiece, 0 … 1
    std::optional<PictureSection> section;
    std::optional<ZeroPlace> zero;   ///< program zero; empty: not drawn
    Theme theme = Theme::dark;       ///< theme of the colours
    int width = 1600, height = 1000; ///< pixels
};

/// Draws the content as the window would, in full detail. Needs no display, but a QGuiApplication for its text (on the
/// "offscreen" platform), and must be used only on the application's thread: an EGL context without a surface (Mesa) is
/// created for it. The workpiece is meshed on a separate thread without blocking the caller; between calls no context
/// is current.
class PictureDrawing {
public:
    /// Takes some tenths of a second for a large part. Errors: notSupported (no EGL with OpenGL 3.2), those of
    /// loadPalette.
    static Result<PictureDrawing> begin(const PictureContent& content);
    ~PictureDrawing();
    PictureDrawing(PictureDrawing&&) noexcept;
    PictureDrawing& operator=(PictureDrawing&&) noexcept;

    /// Takes over the meshes that are finished; takes some milliseconds. @return whether the meshing is complete
    bool ready();
    void wait(); ///< blocks until the meshing is complete
    /// Returns a PNG, once it is ready; can be called for several views. Takes a tenth of a second or two.
    std::string draw(StandardView view);

private:
    class Stage;
    explicit PictureDrawing(std::unique_ptr<Stage> stage);
    std::unique_ptr<Stage> stage_;
};

/// Draws a picture in one call, waiting for the mesher: takes some seconds. @return PNG. Errors: those of
/// PictureDrawing::begin.
Result<std::string> drawPicture(const PictureContent& content);

} // namespace burin
