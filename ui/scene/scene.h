// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/scene/camera_view.h"
#include "ui/scene/colour_scale.h"
#include "ui/scene/compared_path.h"
#include "ui/scene/deviation_actors.h"
#include "ui/scene/edited_path.h"
#include "ui/scene/force_arrow.h"
#include "ui/scene/gizmo_actors.h"
#include "ui/scene/ground_grid.h"
#include "ui/scene/ground_shadow.h"
#include "ui/scene/guide_actors.h"
#include "ui/scene/live_path.h"
#include "ui/scene/marked_lines.h"
#include "ui/scene/measure_marks.h"
#include "ui/scene/obstacle_actors.h"
#include "ui/scene/other_paths.h"
#include "ui/scene/part_actors.h"
#include "ui/scene/preview_stage.h"
#include "ui/scene/scale_bar.h"
#include "ui/scene/section_actors.h"
#include "ui/scene/stock_outline.h"
#include "ui/scene/stylus_ghost.h"
#include "ui/scene/tool_actors.h"
#include "ui/scene/touch_mark.h"
#include "ui/scene/touched_voxels_actor.h"
#include "ui/scene/valued_path.h"
#include "ui/scene/view_cube.h"
#include "ui/scene/workpiece_actors.h"
#include "ui/scene/zero_mark.h"

#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <functional>

namespace burin {

/// The whole scene, or in its place the preview of a part that is being read, in one VTK window of four layers: the
/// workpiece, the guides with the workpiece's depths, the marks that must never be hidden (ghost, coupling, force,
/// guides seen through other objects), the view cube. Independent of Qt widgets. GUI thread.
class Scene {
public:
    /// @param workpieceReady called on a worker thread when there is more of the workpiece to draw
    /// @param surfaces creates the surfaces of guides, @param obstacles those of obstacles
    Scene(vtkRenderWindow& window, std::function<void()> workpieceReady, GuideActors::SurfaceMaker surfaces,
          ObstacleActors::SurfaceMaker obstacles);

    void setPalette(const Palette& palette);
    void setLengthUnit(LengthUnit unit) {
        scaleBar_.setUnit(unit);
        preview_.setLengthUnit(unit);
        touch_.setUnit(unit);
        valuedPath_.setUnit(unit);
        unit_ = unit;
        fillExcessScale();
    }
    void setPart(std::vector<ShadedBody> bodies, const Box& box);
    /// Draws the part moved from its position in the newest part that was announced or set.
    void movePart(const Placement& by);
    /// Announces a part that will be set and has been moved as the part drawn now.
    void announcePart();
    void setCoarsePart(const CoarseBodies& coarse) { part_.setCoarse(coarse); }
    void setHiddenBodies(std::vector<bool> hidden) { part_.setHidden(std::move(hidden)); } ///< by body
    void setBodyColours(std::vector<std::optional<QColor>> colours) { part_.setBodyColours(std::move(colours)); }
    /// Shown instead of everything else until it is cleared. @param content box that a fitted view shows, mm
    void setPreview(std::vector<ShadedBody> bodies, const Box& content);
    void clearPreview();
    bool previewing() const noexcept { return preview_.shown(); }
    /// std::nullopt: visible as long as no workpiece is visible.
    void setPartVisible(std::optional<bool> visible);
    void setStock(const std::optional<Box>& stock);
    void setWorkpiece(const VolumeSnapshot& workpiece, std::optional<std::chrono::steady_clock::time_point> oldestCut);
    void setWorkpieceVisible(bool visible);
    void setWorkpieceOpacity(double opacity); ///< 0 … 1; less than 1: the part is visible in it
    /// Colours the workpiece by the stock left on the part, with a colour scale; std::nullopt: by material.
    void setExcess(std::optional<ExcessColours> left);
    void setSection(const std::optional<SectionPlane>& plane);
    SectionActors& section() noexcept { return section_; }
    void setTool(const std::optional<Tool>& tool);
    void setToolVisible(bool visible);
    /// @param flashLit whether an alarm's flash is in its bright half
    void setMarks(const ToolMarks& marks, bool flashLit);
    /// While there is a mark, the part is visible through the stock.
    void setPressMark(const std::optional<PressMark>& mark);
    /// Shows the part through the stock, with or without a press mark.
    void setPartSeen(bool seen);
    void setObstacles(std::vector<ObstacleMark> marks);
    void setZero(const std::optional<ZeroPlace>& zero) { zero_.set(zero); }
    void setGuides(const GuideMarks& marks) { guides_.set(marks); }
    LivePath& livePath() noexcept { return livePath_; }
    EditedPath& editedPath() noexcept { return editedPath_; }
    OtherPaths& otherPaths() noexcept { return otherPaths_; }
    ComparedPath& comparedPath() noexcept { return comparedPath_; }
    /// Colours the edited path's moves at feed by a quantity; null: by kind of move.
    void setPathValues(std::shared_ptr<const PathValues> values);
    void setPathVisible(bool visible);
    /// Replaces the part's own surface. Without triangles: none.
    void setDeviations(const DeviationSurface& surface);
    TouchedVoxelsActor& touchedVoxels() noexcept { return touchedVoxels_; }
    MarkedLines& moveMark() noexcept { return moveMark_; }
    MarkedLines& outlines() noexcept { return outlines_; }
    MarkedLines& strokePlans() noexcept { return strokePlans_; }
    MarkedLines& area() noexcept { return area_; }
    MarkedLines& passPreview() noexcept { return passPreview_; }
    MeasureMarks& measure() noexcept { return measure_; }
    GizmoActors& gizmo() noexcept { return gizmo_; }
    ViewCube& cube() noexcept { return cube_; }
    const WorkpieceActors& workpiece() const noexcept { return workpiece_; }

    /// The box that `fit` shows: part, stock, workpiece and the obstacles around them, or the preview. Not the tool,
    /// which may be far away.
    Box contentBox() const;
    /// The nearest point of workpiece or part, or of the preview, on a sight line; std::nullopt if it misses them.
    std::optional<glm::dvec3> pick(const Sight& sight) const;
    /// The workpiece that is drawn; empty: none, or it is hidden.
    VolumeSnapshot seenWorkpiece() const { return workpieceSeen() ? shown_ : VolumeSnapshot(); }
    /// Prepares everything for a paint.
    /// @param size of the widget, device-independent pixels; @param ratio screen pixels per device-independent pixel
    /// @param moving whether view, tool or workpiece are in motion: coarse detail is then sufficient
    /// @return time of the oldest cut that this paint is the first to show
    std::optional<std::chrono::steady_clock::time_point> prepare(const CameraView& view, const QSizeF& size,
                                                                 double ratio, bool moving);
    std::size_t triangles() const;

private:
    bool workpieceSeen() const noexcept { return workpieceVisible_ && !shown_.empty(); }
    void refresh();
    void colourPart();
    void fillExcessScale();
    void setLineWidths(double ratio);
    void aimCamera(vtkRenderer& renderer, const Box& bounds, const CameraView& view);
    Box drawnBounds();
    DepthCue depthCue(vtkRenderer& renderer) const;
    std::vector<CutPlace> cuts() const; ///< those that must not be hidden

    vtkNew<vtkRenderer> solids_, films_, marks_;
    PreviewStage preview_;
    PartActors part_;
    WorkpieceActors workpiece_;
    ToolActors tool_;
    LivePath livePath_;
    OtherPaths otherPaths_;
    EditedPath editedPath_;
    ValuedPath valuedPath_;
    ComparedPath comparedPath_;
    DeviationActors deviations_;
    GroundGrid grid_;
    GroundShadow shadow_;
    StockOutline stock_;
    ScaleBar scaleBar_;
    ObstacleActors obstacles_;
    GuideActors guides_;
    SectionActors section_;
    StylusGhost ghost_;
    TouchMark touch_;
    ZeroMark zero_;
    TouchedVoxelsActor touchedVoxels_;
    MarkedLines moveMark_, outlines_, strokePlans_, area_, passPreview_;
    MeasureMarks measure_;
    ForceArrow force_;
    GizmoActors gizmo_;
    ViewCube cube_;
    ColourScale excessScale_;

    std::optional<ExcessColours> left_;
    QColor partColour_, edgeColour_;
    LengthUnit unit_{}; ///< millimetre
    Box partBox_;
    Placement announced_, moved_; ///< motion of the part that was announced, and beyond it
    std::optional<bool> partRequest_;
    VolumeSnapshot shown_;
    std::uint64_t workpieceDrawn_ = 0; ///< the volume behind which the part is drawn
    bool partSeen_ = false;            ///< whether it was requested to be visible through the stock
    bool seenThrough_ = false;         ///< whether the workpiece is transparent
    bool workpieceVisible_ = true, toolVisible_ = true;
    ToolMarks toolMarks_;
    double lineRatio_ = 0.0;
};

} // namespace burin
