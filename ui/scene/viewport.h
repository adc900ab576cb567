// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cad/model.h"
#include "core/cad/model_preview.h"
#include "core/geometry/placement.h"
#include "core/job/path_values.h"
#include "core/path/evaluate.h"
#include "core/recording/sample.h"
#include "core/tool/tool.h"
#include "core/verify/verify.h"
#include "core/volume/runs/run_volume.h"
#include "ui/scene/camera_push.h"
#include "ui/scene/comparison_mark.h"
#include "ui/scene/deviation_surface.h"
#include "ui/scene/excess_colours.h"
#include "ui/scene/gizmo.h"
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
class QSinglePointEvent;

namespace burin {

enum class StandardView { isometric, top, bottom, front, back, left, right };

/// The state of the tool at one tick, as it is drawn.
struct ToolMarks {
    ToolPose proxy;
    glm::dvec3 stylusTip{0.0}; ///< mm, setup frame: the tip position commanded by the hand; drawn as a ghost with the
                               ///< coupling to the proxy
    glm::dvec3 force{0.0};     ///< N, setup frame: drawn as an arrow with its value
    bool ghost = false;
    bool alarm = false; ///< shank contact: shank and holder flash
    bool cutting = false;
};

struct CameraView;

/// Drawing performance, for the status line and benchmarks. Times in ms, since the last `resetStatistics`.
struct FrameStatistics {
    std::size_t frames = 0;
    double paintMaximum = 0.0, paintP95 = 0.0;             ///< of one paint, GUI thread
    double cutToScreenP95 = 0.0, cutToScreenMaximum = 0.0; ///< from a cut's tick to the end of the paint that shows it
    std::size_t cutsShown = 0;
    std::size_t triangles = 0; ///< drawn in the newest frame
    bool fullDetail = false;   ///< of the newest frame
    bool busy = false;         ///< whether a worker is still meshing
};

/// The viewport: owns a canvas and the VTK render window that draws on it (the only Qt widget that depends on VTK).
/// Draws only the data passed to it; never waits for the meshing worker. Mouse: middle or right drag orbits, Shift +
/// middle drag (or middle + right) pans, wheel zooms to the cursor, unless the active tool handles the event. A pen of
/// a tablet does the same: its tip is the left button, the buttons of its barrel are the others; the mouse rests while
/// the pen touches. GUI thread.
class Viewport : public QWidget {
    Q_OBJECT
public:
    /// Why this machine can't draw, as a sentence for the user; empty: it can. Creates a temporary context. Call before
    /// creating a viewport.
    static QString drawingObstacle();

    explicit Viewport(QWidget* parent = nullptr);
    ~Viewport() override;

    void setPalette3D(const Palette& palette);
    /// The unit of the scale bar and other labels.
    void setLengthUnit(LengthUnit unit);
    /// Sets the bare part, drawn until there is a workpiece (and on request together with it). Null: none.
    void setPart(std::shared_ptr<const Model> model);
    /// As setPart, for the part whose preview is shown: the preview stays until the part can be drawn, which is then
    /// shown from the same view. If no preview was drawn yet, the part is fitted into the picture.
    void setPreviewedPart(std::shared_ptr<const Model> model);
    /// Sets a preview that is drawn instead of everything else, as soon as it is ready, and fitted into the picture;
    /// meanwhile the interactive tool gets no events, and nothing is picked. Null: back to the previous content and
    /// view.
    /// @param margin around it that is also in the picture, mm
    void setPreview(const std::shared_ptr<const ModelPreview>& preview, double margin = 0.0);
    bool showsPreview() const; ///< whether a preview is drawn
    /// Draws the part moved from its position in the model that was set last, until the next one is drawn.
    void movePart(const Placement& by);
    void setPartVisible(bool visible);
    void setHiddenBodies(std::vector<bool> hidden); ///< of the part, by body; the others are drawn
    /// Of the part, by body; empty: the part's blue. The others have the colours of the model.
    void setBodyColours(std::vector<std::optional<QColor>> colours);
    /// The outline of the future stock, mm, setup frame; std::nullopt: none.
    void setStockOutline(const std::optional<Box>& stock);
    /// Sets the current workpiece: changed bricks are meshed on the worker thread and drawn when they are ready.
    /// @param oldestCut for the statistics. An empty snapshot: no workpiece.
    void setWorkpiece(const VolumeSnapshot& workpiece,
                      std::optional<std::chrono::steady_clock::time_point> oldestCut = std::nullopt);
    /// The workpiece that is drawn; empty: none, or it is hidden.
    VolumeSnapshot workpiece() const;
    void setWorkpieceVisible(bool visible);
    /// 0 … 1. Less than 1: the part is visible in the workpiece.
    void setWorkpieceOpacity(double opacity);
    /// Colours the workpiece by the stock left on the part, with a colour scale; std::nullopt: by material.
    void setExcess(std::optional<ExcessColours> left);
    /// Cuts part and workpiece open, only in the picture. A handle moves the plane: see `sectionDragged`.
    void setSection(const std::optional<SectionPlane>& plane);
    /// The bounding box of part, stock, workpiece and the obstacles around them, mm, setup frame.
    Box contentBox() const;
    void setTool(const std::optional<Tool>& tool);
    void setToolMarks(const ToolMarks& marks);
    void setToolVisible(bool visible);
    /// Where a press would move the tool: drawn together with the part, both visible through the stock; std::nullopt:
    /// neither.
    void setPressMark(const std::optional<PressMark>& mark);
    /// Sets fixtures and keep-out volumes; may be called at every tick.
    void setObstacles(const std::vector<ObstacleMark>& obstacles);
    void setPartSeen(bool seen);                        ///< through the stock, while something on it is to be picked
    void setZero(const std::optional<ZeroPlace>& zero); ///< std::nullopt: none is drawn
    /// Sets the guides (virtual fixtures); may be called at every tick, since only changes are rebuilt. Curves must
    /// exist as long as they are shown.
    void setGuides(const GuideMarks& guides);
    /// Adds to the path that is being recorded: tips, mm; `newStroke` begins a new stroke.
    void appendLivePath(std::span<const glm::vec3> tips, bool newStroke);
    void clearLivePath();
    /// Sets the edited path, coloured by kind of move and by the milling side.
    void setPath(const EvaluatedPath& path);
    /// Colours the path's moves at feed by a quantity, with a colour scale; null: by kind of move.
    void setPathValues(std::shared_ptr<const PathValues> values);
    void setPathVisible(bool visible);
    /// Sets the paths that the job mills with other tools.
    void setOtherPaths(const std::vector<std::shared_ptr<const EvaluatedPath>>& paths);
    void setOtherPathsVisible(bool visible);
    /// Shows the path that the edited one is compared with; an empty mark shows none.
    void setComparison(const ComparisonMark& mark);
    /// Shows what a program leaves on the part, or removes from it, in colours on the part. The coloured surface is
    /// computed on a worker thread and stays until a picture without samples is set.
    void setDeviations(const DeviationPicture& picture);
    /// Sets the voxels that shank or holder touch, drawn as cubes; empty: none.
    void setTouchedVoxels(const std::vector<TouchedVoxels>& areas);
    /// Sets the selected or inspected part of a path.
    void setMoveMark(const PlaceChains& moves);
    /// Sets what the user drew for the path: areas, guides.
    void setOutlines(const PlaceChains& lines);
    /// Sets what the tool has yet to cut: the pointer's trail, a planned line or rows.
    void setStrokePlans(const PlaceChains& lines);
    /// Sets the area of the next pass, as lines on the part.
    void setArea(const PlaceChains& lines);
    void setMeasureMark(const std::optional<MeasureMark>& mark); ///< the measurement; std::nullopt: none
    void setGizmo(const std::optional<GizmoMark>& mark);         ///< std::nullopt: none
    /// Sets the strokes of a pass that is not computed yet.
    void setPassPreview(const PlaceChains& lines);

    /// A view straight along an axis is parallel, regardless of `setParallel`, until it is rotated.
    void setStandardView(StandardView view);
    const CameraView& cameraView() const noexcept;
    void setCameraView(const CameraView& view); ///< at once
    void fit();
    /// Moves the view by a 3D mouse. @param seconds duration of the push
    void push(const CameraPush& push, double seconds);
    /// The projection of all other views: parallel or perspective.
    void setParallel(bool parallel);
    /// Not owned; nullptr: only the camera.
    void setInteractiveTool(InteractiveTool* tool);
    InteractiveTool* interactiveTool() const; ///< null: only the camera
    /// Sets the tool of handles that are drawn over everything: each event is offered to it before the interactive
    /// tool. Not owned; nullptr: none.
    void setHandleTool(InteractiveTool* tool);
    InteractiveTool* handleTool() const; ///< null: none
    /// The sight line through a position of the widget (device-independent pixels).
    ViewportEvent sight(const QPointF& position) const;
    /// The point of workpiece or part that appears at a position, mm, setup frame; std::nullopt if nothing is there, or
    /// while a preview is shown.
    std::optional<glm::dvec3> pick(const QPointF& position) const;
    /// The position at which a point of the setup frame appears, device-independent pixels.
    QPointF project(const glm::dvec3& place) const;

    /// Call before anything is shown: prepares the drawing of a part in some turns of the event loop, so that the first
    /// picture of a part doesn't block the thread. Does nothing once there is a part or the view is shown.
    void warmUp();
    bool isValid() const; ///< whether it can draw
    /// Draws and returns the picture, in screen pixels.
    QImage grabFramebuffer();

    FrameStatistics statistics() const;
    void resetStatistics();

signals:
    /// Emitted after each paint.
    void painted();
    void interactiveToolChanged();
    /// Emitted while the user drags the section plane. @param position mm along its axis, within the content
    void sectionDragged(double position);
    /// Emitted if OpenGL is too old; the sentence is for the user, as from `drawingObstacle`.
    void drawingFailed(const QString& sentence);
    void penNoticed(); ///< when a pen comes near the view, at its first event there

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void tabletEvent(QTabletEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    static QString obstacleOf(const QOpenGLContext* context);
    void pressPointer(const QSinglePointEvent& event);
    void movePointer(const QSinglePointEvent& event);
    void releasePointer(const QSinglePointEvent& event);
    void losePen();

    class Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace burin
