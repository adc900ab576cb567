// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/input/path_hand.h"
#include "ui/panels/panel_states.h"
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
    bool drawing() const noexcept { return drawing_; }
    void setDrag(DragChoice drag);
    void setDrawing(bool wanted);

signals:
    void changed(); ///< drag or drawing

private:
    void present() override;
    void takePath();
    void markSelection();
    void showDrag(std::size_t place, const glm::dvec3& by);
    void drop(std::size_t place, const glm::dvec3& by);
    void finishDrawing(const std::vector<glm::dvec3>& places);
    Moment momentOf(std::size_t place) const;
    std::optional<double> selectionHeight() const;

    Viewport& viewport_;
    PathHand hand_;
    std::shared_ptr<const EvaluatedPath> path_; ///< whose places the hand has; null while it is not active
    DragChoice drag_ = DragChoice::level;
    bool shown_ = false, active_ = false, drawing_ = false;
};

} // namespace burin
