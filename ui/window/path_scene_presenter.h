// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/input/path_hand.h"
#include "ui/panels/job_states.h"
#include "ui/panels/path_states.h"
#include "ui/scene/viewport.h"
#include "ui/window/presenter.h"

namespace burin {

/// The pointer on the path: what is chosen is marked in the viewport, places are dragged, strokes drawn. While the
/// path's step is shown and no tool is in hand.
class PathScenePresenter final : public Presenter {
    Q_OBJECT
public:
    PathScenePresenter(Workbench& workbench, Viewport& viewport, QObject* parent);
    void setShown(JobStep step);

    DragChoice drag() const noexcept { return drag_; }
    /// A stroke in the selection's stead.
    bool drawing() const noexcept { return drawing_ && !field_; }
    /// Of an edit.
    const std::optional<DrawnField>& drawnField() const noexcept { return field_; }
    void setDrag(DragChoice drag);
    void setDrawing(bool wanted);
    void setFieldDrawing(const DrawnField& field, bool wanted);
    /// Draws what the last edit that can be drawn is made of; once more: no longer.
    void toggleLastDrawing();
    /// Adds an edit to the path; one that needs places has them drawn next.
    void addEdit(const Edit& edit);
    /// Marks a place, and brings it to the picture's middle. @param place mm, setup frame
    void lookAt(const glm::dvec3& place);

signals:
    void changed();       ///< drag or drawing
    void escapeChanged(); ///< what Esc does may be another

private:
    void present() override;
    void takePath();
    void markSelection();
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
    std::optional<double> heightOf(const std::optional<SourceStretch>& stretch) const;

    Viewport& viewport_;
    PathHand hand_;
    std::shared_ptr<const EvaluatedPath> path_; ///< whose places the hand has; null while it is not active
    DragChoice drag_ = DragChoice::level;
    std::vector<glm::dvec3> drawn_;   ///< of the stroke under way
    std::string drawnFor_;            ///< the edit that `field_` is of, as it was
    std::optional<DrawnField> field_; ///< that is drawn; nothing: what is drawn is meant for the selection
    bool shown_ = false, active_ = false, drawing_ = false;
};

} // namespace burin
