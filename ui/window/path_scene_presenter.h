// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/path/inserted_points.h"
#include "ui/input/path_hand.h"
#include "ui/panels/job_states.h"
#include "ui/panels/path_states.h"
#include "ui/scene/viewport.h"
#include "ui/window/presenter.h"

#include <utility>

namespace burin {

/// The pointer on the path: the selection is marked in the viewport, points are dragged, strokes drawn. Active while
/// the path step is shown and no tool is being moved.
class PathScenePresenter final : public Presenter {
    Q_OBJECT
public:
    PathScenePresenter(Workbench& workbench, Viewport& viewport, QObject* parent);
    void setShown(JobStep step);

    DragChoice drag() const noexcept { return drag_; }
    /// Whether a stroke that replaces the selection is being drawn.
    bool drawing() const noexcept { return drawing_ && !field_; }
    /// The field of an edit that is being drawn.
    const std::optional<DrawnField>& drawnField() const noexcept { return field_; }
    void setDrag(DragChoice drag);
    void setDrawing(bool wanted);
    void setFieldDrawing(const DrawnField& field, bool wanted);
    /// Draws the drawable field of the last edit that has one; called again: stops.
    void toggleLastDrawing();
    /// Adds an edit to the path; if it needs points, drawing them starts.
    void addEdit(const Edit& edit);
    /// Inserts a point at the start of the selection, or where the user clicked to select it.
    void insertAtSelection();
    void takeKeys() { viewport_.setFocus(); } ///< so that Esc reaches the path
    /// Marks drawn in addition to the selection, mm, setup frame.
    void setStylusMarks(const PlaceChains& marks);
    /// Marks a point, points at its moment, and centres the view on it. @param place mm, setup frame
    void lookAt(const glm::dvec3& place);

signals:
    void changed();       ///< mode of dragging or drawing
    void escapeChanged(); ///< the meaning of Esc may have changed

private:
    void present() override;
    void takePath();
    void takeInserted();
    void followTime();
    std::optional<glm::dvec3> placeOnPath() const;
    void showMenu(const PathPlace& place, const QPointF& position);
    void showHandleDrag(std::size_t handle, const std::optional<PathPlace>& place, const glm::dvec3& by);
    void markSelection();
    void drawMarks();
    bool leadStylus(const PathGrip& grip, const glm::dvec3& by);
    void escape();
    void startDrawing(std::optional<double> height);
    void showDrawing(const std::vector<glm::dvec3>& places);
    void showOutlines();
    std::vector<glm::dvec3> asTheHandWent(std::vector<glm::dvec3> places) const;
    bool drawsArea() const;
    std::vector<glm::dvec3> outlineOf(const Mirror& mirror) const;
    bool stillMeant() const;
    Edit withinStock(Edit edit) const;
    void showDrag(const PathPlace& place, const glm::dvec3& by);
    void drop(const PathPlace& place, const glm::dvec3& by);
    void finishDrawing(const std::vector<glm::dvec3>& places);
    Moment momentOf(const PathPlace& place) const;
    std::vector<std::vector<PathPoint>> chosenPoints() const;
    std::optional<double> heightOf(const std::optional<SourceInterval>& interval) const;

    Viewport& viewport_;
    PathHand hand_;
    std::shared_ptr<const EvaluatedPath> path_; ///< path whose points can be picked; null while inactive
    std::vector<InsertedPoint> inserted_;       ///< of `path_`; the handles of the pointer, in their order
    PlaceChains marks_, stylusMarks_;           ///< of the selection; in addition
    /// The moment at which the user clicked last, and the edit that inserts a point just there.
    std::pair<Moment, InsertPoint> clicked_;
    std::optional<glm::dvec3> shownPlace_; ///< mm, of the path at the time on the timeline; empty: none
    std::optional<glm::dvec3> lookedAt_;   ///< mm; empty: the selection is marked
    DragChoice drag_ = DragChoice::level;
    std::vector<glm::dvec3> drawn_;   ///< of the stroke under way
    std::string drawnFor_;            ///< state of the edit of `field_` when drawing began
    std::optional<DrawnField> field_; ///< being drawn; empty: the drawing is for the selection
    bool shown_ = false, active_ = false, drawing_ = false;
};

} // namespace burin
