// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/path_scene_presenter.h"

#include "core/base/units.h"

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

/// By the hand; what an edit made of nothing has no moment to be named by.
bool isOfTheHand(const PathPoint& point) {
    return point.take != 0 && point.sample >= 0;
}

/// How a stroke follows the place that is dragged, as MovePoints does it: along the stroke, ever less.
class Falloff {
public:
    Falloff(const std::vector<PathPoint>& points, std::size_t place, const glm::dvec3& by)
        : points_(points), place_(place), by_(by) {}

    std::vector<glm::dvec3> places() const {
        std::vector<glm::dvec3> moved{points_[place_].tip + by_};
        follow(moved, -1);
        std::ranges::reverse(moved);
        follow(moved, 1);
        return moved;
    }

private:
    void follow(std::vector<glm::dvec3>& moved, int step) const {
        const double reach = MovePoints{}.falloff;
        double way = 0.0;
        for (std::size_t i = place_; way < reach;) {
            if ((step < 0 && i == 0) || (step > 0 && i + 1 == points_.size())) return;
            const std::size_t next = step < 0 ? i - 1 : i + 1;
            if (!isOfTheHand(points_[next]) || points_[next].take != points_[i].take) return;
            way += glm::distance(points_[next].tip, points_[i].tip);
            const double share = way < reach ? 0.5 * (1.0 + std::cos(pi * way / reach)) : 0.0;
            moved.push_back(points_[next].tip + share * by_);
            i = next;
        }
    }

    const std::vector<PathPoint>& points_;
    std::size_t place_;
    glm::dvec3 by_;
};

} // namespace

PathScenePresenter::PathScenePresenter(Workbench& workbench, Viewport& viewport, QObject* parent)
    : Presenter(workbench, {&workbench.path, &workbench.mill}, parent)
    , viewport_(viewport)
    , hand_([&viewport](const glm::dvec3& place) { return viewport.project(place); }) {
    connect(&hand_, &PathHand::chosen, this, [this](std::size_t place, bool extend) {
        extend ? workbench_.path.selectTo(momentOf(place)) : workbench_.path.select(momentOf(place));
    });
    connect(&hand_, &PathHand::dragging, this, &PathScenePresenter::showDrag);
    connect(&hand_, &PathHand::dropped, this, &PathScenePresenter::drop);
    connect(&hand_, &PathHand::drawing, this,
            [this](const std::vector<glm::dvec3>& places) { viewport_.setMoveMark(places); });
    connect(&hand_, &PathHand::drawn, this, &PathScenePresenter::finishDrawing);
    connect(&hand_, &PathHand::givenUp, this, &PathScenePresenter::markSelection);
    connect(&hand_, &PathHand::cleared, this,
            [this] { drawing_ ? setDrawing(false) : workbench_.path.clearSelection(); });
}

void PathScenePresenter::setShown(JobStep step) {
    shown_ = step == JobStep::path;
    present();
}

void PathScenePresenter::setDrag(DragChoice drag) {
    drag_ = drag;
    hand_.setAlong(static_cast<DragAlong>(drag));
    emit changed();
}

void PathScenePresenter::setDrawing(bool wanted) {
    drawing_ = wanted && workbench_.path.selection();
    hand_.setDrawing(drawing_ ? selectionHeight() : std::nullopt);
    emit changed();
}

void PathScenePresenter::present() {
    const bool active = shown_ && workbench_.path.evaluated() && !workbench_.mill.active();
    if (active != active_) {
        active_ = active;
        // In mill mode the pointer is the mill's own.
        if (active || !workbench_.mill.active()) viewport_.setInteractiveTool(active ? &hand_ : nullptr);
        if (!active) viewport_.setMoveMark({});
    }
    takePath();
    if (drawing_ && (!active || !workbench_.path.selection())) setDrawing(false);
    if (active_) markSelection();
}

void PathScenePresenter::takePath() {
    const auto path = active_ ? workbench_.path.evaluated() : nullptr;
    if (path == path_) return;
    path_ = path;
    std::vector<glm::dvec3> places;
    std::vector<bool> usable;
    if (path_)
        for (const PathPoint& point : path_->path.points) {
            places.push_back(point.tip);
            usable.push_back(isOfTheHand(point) && point.kind != MoveKind::rapid);
        }
    hand_.setPlaces(std::move(places), std::move(usable));
}

void PathScenePresenter::markSelection() {
    std::vector<glm::dvec3> places;
    const auto& selection = workbench_.path.selection();
    if (path_ && selection)
        for (std::size_t i = 0; i < path_->path.points.size(); ++i)
            if (isOfTheHand(path_->path.points[i]) && selection->contains(momentOf(i)))
                places.push_back(path_->path.points[i].tip);
    viewport_.setMoveMark(places);
}

void PathScenePresenter::showDrag(std::size_t place, const glm::dvec3& by) {
    if (path_) viewport_.setMoveMark(Falloff(path_->path.points, place, by).places());
}

void PathScenePresenter::drop(std::size_t place, const glm::dvec3& by) {
    if (!path_) return;
    workbench_.path.movePlace(momentOf(place), by,
                              drag_ == DragChoice::surface ? MovePoints::Along::surface : MovePoints::Along::free);
}

void PathScenePresenter::finishDrawing(const std::vector<glm::dvec3>& places) {
    setDrawing(false);
    workbench_.path.replaceSelection(places);
}

Moment PathScenePresenter::momentOf(std::size_t place) const {
    const PathPoint& point = path_->path.points[place];
    return {point.take, point.sample};
}

std::optional<double> PathScenePresenter::selectionHeight() const {
    const auto& selection = workbench_.path.selection();
    if (!path_ || !selection) return std::nullopt;
    for (std::size_t i = 0; i < path_->path.points.size(); ++i)
        if (isOfTheHand(path_->path.points[i]) && selection->contains(momentOf(i))) return path_->path.points[i].tip.z;
    return std::nullopt;
}

} // namespace burin
