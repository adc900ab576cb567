// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/model.h"
#include "core/cad/model_preview.h"
#include "core/job/path_values.h"
#include "core/path/evaluate.h"
#include "core/recording/sample.h"
#include "core/tool/tool.h"
#include "core/verify/verify.h"
#include "core/volume/runs/run_volume.h"
#include "ui/scene/camera_push.h"
#include "ui/scene/deviation_surface.h"
#include "ui/scene/excess_colours.h"
#include "ui/scene/guide_marks.h"
#include "ui/scene/interactive_tool.h"
#include "ui/scene/measure_mark.h"
#include "ui/scene/obstacle_mark.h"
#include "ui/scene/place_chains.h"
#include "ui/scene/press_mark.h"
#include "ui/scene/section_plane.h"
#include "ui/scene/zero_place.h"
#include "ui/theme/length_unit.h"
#include "ui/theme/theme.h"

#include <QWidget>

#include <chrono>
#include <memory>
#include <optional>
#include <span>

class QOpenGLContext;

namespace burin {

enum class StandardView { isometric, top, bottom, front, back, left, right };

/// What a tick looks like.
struct ToolMarks {
    ToolPose proxy;
    glm::dvec3 stylusTip{
        0.0}; ///< mm, setup frame: where the hand wants it; drawn as a ghost with the coupling to the proxy
    glm::dvec3 force{0.0}; ///< N, setup frame: the arrow, with its value
    bool ghost = false;
    bool alarm = false; ///< shank contact: shank and holder flash
    bool cutting = false;
};

struct CameraView;

/// How drawing has kept up; for the status line and benchmarks. Times in ms, since the last `resetStatistics`.
struct FrameStatistics {
    std::size_t frames = 0;
    double paintMaximum = 0.0, paintP95 = 0.0;             ///< of one paint, GUI thread
    double cutToScreenP95 = 0.0, cutToScreenMaximum = 0.0; ///< from a cut's tick to the end of the paint that shows it
    std::size_t cutsShown = 0;
    std::size_t triangles = 0; ///< drawn in the newest frame
    bool fullDetail = false;   ///< of the newest frame
    bool busy = false;         ///< a worker is still meshing
};

/// The viewport: owns a canvas and the VTK render window that draws on it (the only Qt widget that knows VTK). Draws
/// what it is given and asks for nothing; never waits for the worker that meshes.
/// Mouse: middle or right drag orbits, Shift + middle drag (or middle + right) pans, wheel zooms to the cursor, unless
/// the active tool takes the event. Thread: user interface.
class Viewport : public QWidget {
    Q_OBJECT
public:
    /// Why this machine can't draw, a sentence for the user; empty: it can. Makes a context for a moment. To be asked
    /// before a viewport is made.
    static QString drawingObstacle();

    explicit Viewport(QWidget* parent = nullptr);
    ~Viewport() override;

    void setPalette3D(const Palette& palette);
    /// Of the scale bar.
    void setLengthUnit(LengthUnit unit);
    /// The bare part, drawn until there is a workpiece (and on wish beside it). Null: none.
    void setPart(std::shared_ptr<const Model> model);
    /// As setPart, of the part whose preview is drawn: that stays until the part can be drawn, which is seen from where
    /// the preview was. Where no preview was drawn yet, the part is fitted into the picture.
    void setPreviewedPart(std::shared_ptr<const Model> model);
    /// Drawn in the stead of everything else, as soon as it can be, and fitted into the picture; the interactive tool
    /// then gets nothing, and nothing is picked. Null: what was drawn before, seen from where it was.
    /// @param margin around it that is in the picture, too, mm
    void setPreview(const std::shared_ptr<const ModelPreview>& preview, double margin = 0.0);
    bool showsPreview() const; ///< it is drawn
    void setPartVisible(bool visible);
    void setHiddenBodies(std::vector<bool> hidden); ///< of the part, by body; the others are drawn
    /// Outline of the stock to be, mm, setup frame. Nothing: none.
    void setStockOutline(const std::optional<Box>& stock);
    /// The workpiece as it is now: bricks that changed are meshed on the worker's thread and drawn when they are ready.
    /// @param oldestCut for the statistics. An empty snapshot: none.
    void setWorkpiece(const VolumeSnapshot& workpiece,
                      std::optional<std::chrono::steady_clock::time_point> oldestCut = std::nullopt);
    void setWorkpieceVisible(bool visible);
    /// Less than 1: the part is seen in the workpiece. 0 … 1
    void setWorkpieceOpacity(double opacity);
    /// The workpiece in the colours of what is left on the part, with their scale; nothing: by material.
    void setExcess(std::optional<ExcessColours> left);
    /// Cuts part and workpiece open in the picture alone. A handle moves the plane: see `sectionDragged`.
    void setSection(const std::optional<SectionPlane>& plane);
    /// Part, stock and workpiece, and what stands around them, mm, setup frame.
    Box contentBox() const;
    void setTool(const std::optional<Tool>& tool);
    void setToolMarks(const ToolMarks& marks);
    void setToolVisible(bool visible);
    /// Where a press would lead the tool: drawn with the part, both seen through the stock. Nothing: neither.
    void setPressMark(const std::optional<PressMark>& mark);
    /// Fixtures and keep-out volumes; may come with every tick, too.
    void setObstacles(const std::vector<ObstacleMark>& obstacles);
    void setPartSeen(bool seen);                        ///< through the stock, where something of it is to be picked
    void setZero(const std::optional<ZeroPlace>& zero); ///< nothing: none is drawn
    /// The guides of the hand; may come with every tick, as only what changed is made anew. Curves outlive their show.
    void setGuides(const GuideMarks& guides);
    /// The path as it is recorded: tips, mm; a stroke begins where `newStroke`.
    void appendLivePath(std::span<const glm::vec3> tips, bool newStroke);
    void clearLivePath();
    /// The edited path, colour by kind of move and by the side on which it mills.
    void setPath(const EvaluatedPath& path);
    /// Its moves at feed in the colours of a quantity, with their scale; null: by their kinds.
    void setPathValues(std::shared_ptr<const PathValues> values);
    void setPathVisible(bool visible);
    /// What the job mills with other tools.
    void setOtherPaths(const std::vector<std::shared_ptr<const EvaluatedPath>>& paths);
    void setOtherPathsVisible(bool visible);
    /// What a program leaves on the part, or takes from it, in colours on the part. They come from a worker's thread,
    /// and stand until they are taken away by a picture without samples.
    void setDeviations(const DeviationPicture& picture);
    /// What shank or holder touch, as cubes; none: nothing.
    void setTouchedVoxels(const std::vector<TouchedVoxels>& areas);
    /// What is chosen or looked at of a path.
    void setMoveMark(const PlaceChains& moves);
    /// What the user drew for the path: areas, guides.
    void setOutlines(const PlaceChains& lines);
    /// What the tool has still to cut: the pointer's trail, a line or rows to come.
    void setStrokePlans(const PlaceChains& lines);
    /// The area of the next pass, as lines on the part.
    void setArea(const PlaceChains& lines);
    void setMeasureMark(const std::optional<MeasureMark>& mark); ///< what was measured; nothing: none
    /// Strokes of a pass that is not computed yet.
    void setPassPreview(const PlaceChains& lines);

    /// A view straight along an axis is parallel, whatever else is chosen, until it is turned.
    void setStandardView(StandardView view);
    const CameraView& cameraView() const noexcept;
    void setCameraView(const CameraView& view); ///< at once
    void fit();
    /// As a device in the other hand pushes the picture. @param seconds that the push lasted
    void push(const CameraPush& push, double seconds);
    /// The projection of all other views: parallel, or in perspective.
    void setParallel(bool parallel);
    /// Not owned; nullptr: the camera alone.
    void setInteractiveTool(InteractiveTool* tool);
    InteractiveTool* interactiveTool() const; ///< null: the camera alone
    /// Sight through a place of the widget (device-independent pixels).
    ViewportEvent sight(const QPointF& position) const;
    /// The place of workpiece or part that appears there, mm, setup frame; nothing: the workpiece alone does, or a
    /// preview.
    std::optional<glm::dvec3> pick(const QPointF& position) const;
    /// Where a place in the setup frame appears, device-independent pixels.
    QPointF project(const glm::dvec3& place) const;

    /// Before anything is to be seen: has what draws a part made ready in some turns of the event loop, so that the
    /// first picture of one doesn't hold up the thread. Nothing once there is a part, or the view is shown.
    void warmUp();
    bool isValid() const; ///< it can draw
    /// Draws and gives the picture, in screen pixels.
    QImage grabFramebuffer();

    FrameStatistics statistics() const;
    void resetStatistics();

signals:
    /// After each paint.
    void painted();
    void interactiveToolChanged();
    /// The user drags the section plane. @param position mm along its axis, within the content
    void sectionDragged(double position);
    /// OpenGL is too old; the sentence is for the user, as from `drawingObstacle`.
    void drawingFailed(const QString& sentence);

protected:
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    static QString obstacleOf(const QOpenGLContext* context);

    class Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace burin
