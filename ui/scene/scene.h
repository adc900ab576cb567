// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/scene/camera_view.h"
#include "ui/scene/colour_scale.h"
#include "ui/scene/deviation_actors.h"
#include "ui/scene/edited_path.h"
#include "ui/scene/force_arrow.h"
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

/// Everything that stands on the workpiece, and in its stead what there is to see of a part that is being read, in one
/// VTK window of four layers: the workpiece, the guides with the workpiece's depths, the marks that must never be
/// hidden (ghost, coupling, force, guides seen through), the view cube. Knows no Qt widget. Thread: user interface.
class Scene {
public:
    /// @param workpieceReady called on a worker's thread when there is more of the workpiece to draw
    /// @param surfaces makes the surfaces of guides, @param obstacles those of obstacles
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
    void setCoarsePart(const CoarseBodies& coarse) { part_.setCoarse(coarse); }
    void setHiddenBodies(std::vector<bool> hidden) { part_.setHidden(std::move(hidden)); } ///< by body
    /// In the stead of all else, until it is cleared. @param content what a fitted view shows, mm
    void setPreview(std::vector<ShadedBody> bodies, const Box& content);
    void clearPreview();
    bool previewing() const noexcept { return preview_.shown(); }
    /// Nothing: while there is no workpiece to be seen.
    void setPartVisible(std::optional<bool> visible);
    void setStock(const std::optional<Box>& stock);
    void setWorkpiece(const VolumeSnapshot& workpiece, std::optional<std::chrono::steady_clock::time_point> oldestCut);
    void setWorkpieceVisible(bool visible);
    void setWorkpieceOpacity(double opacity); ///< less than 1: the part is seen in it. 0 … 1
    /// The workpiece by what is left on the part, with the scale of the colours; nothing: by material.
    void setExcess(std::optional<ExcessColours> left);
    void setSection(const std::optional<SectionPlane>& plane);
    SectionActors& section() noexcept { return section_; }
    void setTool(const std::optional<Tool>& tool);
    void setToolVisible(bool visible);
    /// @param flashLit the bright half of an alarm's flash
    void setMarks(const ToolMarks& marks, bool flashLit);
    /// With it the part is seen through the stock.
    void setPressMark(const std::optional<PressMark>& mark);
    /// The part is seen through the stock, mark or not.
    void setPartSeen(bool seen);
    void setObstacles(std::vector<ObstacleMark> marks);
    void setZero(const std::optional<ZeroPlace>& zero) { zero_.set(zero); }
    void setGuides(const GuideMarks& marks) { guides_.set(marks); }
    LivePath& livePath() noexcept { return livePath_; }
    EditedPath& editedPath() noexcept { return editedPath_; }
    OtherPaths& otherPaths() noexcept { return otherPaths_; }
    /// The edited path's moves at feed in the colours of a quantity; null: by their kinds.
    void setPathValues(std::shared_ptr<const PathValues> values);
    void setPathVisible(bool visible);
    /// Stands for the part's own surface. Without triangles: none.
    void setDeviations(const DeviationSurface& surface);
    TouchedVoxelsActor& touchedVoxels() noexcept { return touchedVoxels_; }
    MarkedLines& moveMark() noexcept { return moveMark_; }
    MarkedLines& outlines() noexcept { return outlines_; }
    MarkedLines& strokePlans() noexcept { return strokePlans_; }
    MarkedLines& area() noexcept { return area_; }
    MarkedLines& passPreview() noexcept { return passPreview_; }
    MeasureMarks& measure() noexcept { return measure_; }
    ViewCube& cube() noexcept { return cube_; }
    const WorkpieceActors& workpiece() const noexcept { return workpiece_; }

    /// Part, stock, workpiece and what stands around them, or the preview: what `fit` shows. Not the tool, which may be
    /// far away.
    Box contentBox() const;
    /// The nearest place of workpiece or part, or of the preview, on a sight. Nothing: it misses them.
    std::optional<glm::dvec3> pick(const Sight& sight) const;
    /// Puts everything in its place for a paint.
    /// @param size of the widget, device-independent pixels; @param ratio screen pixels a device-independent one
    /// @param moving view, tool or workpiece are in motion: coarse detail will do
    /// @return when the oldest cut was made that the paint shows first
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
    std::vector<CutPlace> cuts() const; ///< those that nothing may hide

    vtkNew<vtkRenderer> solids_, films_, marks_;
    PreviewStage preview_;
    PartActors part_;
    WorkpieceActors workpiece_;
    ToolActors tool_;
    LivePath livePath_;
    OtherPaths otherPaths_;
    EditedPath editedPath_;
    ValuedPath valuedPath_;
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
    ViewCube cube_;
    ColourScale excessScale_;

    std::optional<ExcessColours> left_;
    QColor partColour_, edgeColour_;
    LengthUnit unit_{}; ///< millimetre
    Box partBox_;
    std::optional<bool> partWish_;
    VolumeSnapshot shown_;
    std::uint64_t workpieceDrawn_ = 0; ///< which volume the part is drawn behind
    bool partSeen_ = false;            ///< asked for, through the stock
    bool seenThrough_ = false;         ///< the workpiece is transparent
    bool workpieceVisible_ = true, toolVisible_ = true;
    ToolMarks toolMarks_;
    double lineRatio_ = 0.0;
};

} // namespace burin
