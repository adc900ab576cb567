// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/path_scene_presenter.h"

#include <algorithm>

namespace burin {

namespace {

constexpr std::string_view areaKey = "outline_mm";

std::vector<glm::dvec3> closed(std::vector<glm::dvec3> outline) {
    if (!outline.empty()) outline.push_back(outline.front());
    return outline;
}

/// An edit of a path, told from all others as long as nobody changes it.
std::string keyOf(const StoredPath& path, std::size_t edit) {
    return std::to_string(path.id) + ' ' + std::to_string(edit) + ' ' + toJson(path.edits[edit]);
}

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
        const MovePoints edit;
        double way = 0.0;
        for (std::size_t i = place_; way < edit.falloff;) {
            if ((step < 0 && i == 0) || (step > 0 && i + 1 == points_.size())) return;
            const std::size_t next = step < 0 ? i - 1 : i + 1;
            if (!isOfTheHand(points_[next]) || points_[next].take != points_[i].take) return;
            way += glm::distance(points_[next].tip, points_[i].tip);
            moved.push_back(points_[next].tip + edit.shareAt(way) * by_);
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
    connect(&hand_, &PathHand::drawing, this, &PathScenePresenter::showDrawing);
    connect(&hand_, &PathHand::drawn, this, &PathScenePresenter::finishDrawing);
    connect(&hand_, &PathHand::givenUp, this, [this] {
        drawn_.clear();
        markSelection();
    });
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
    field_.reset();
    startDrawing(wanted ? heightOf(workbench_.path.selection()) : std::nullopt);
}

void PathScenePresenter::setFieldDrawing(const DrawnField& field, bool wanted) {
    const StoredPath* path = workbench_.path.stored();
    if (!wanted || path == nullptr || field.edit >= path->edits.size()) {
        setDrawing(false);
        return;
    }
    field_ = field;
    drawnFor_ = keyOf(*path, field.edit);
    std::optional<TakeStretch> stretch;
    for (const EditField& each : fieldsOf(path->edits[field.edit].parameters))
        if (const auto* meant = std::get_if<TakeStretch>(&each.value)) stretch = *meant;
    startDrawing(heightOf(stretch));
}

void PathScenePresenter::startDrawing(std::optional<double> height) {
    drawing_ = height.has_value();
    if (!drawing_) field_.reset();
    drawn_.clear();
    hand_.setDrawing(height);
    emit changed();
}

void PathScenePresenter::addEdit(const Edit& edit) {
    const std::size_t place = workbench_.path.addEdit(withinStock(edit));
    for (const EditField& field : fieldsOf(edit.parameters))
        if (const auto* places = std::get_if<std::vector<glm::dvec3>>(&field.value); places && places->empty())
            setFieldDrawing({place, std::string(field.key)}, true);
}

/// An area reaches from the stock's bottom to where travel is free until its heights are said.
Edit PathScenePresenter::withinStock(Edit edit) const {
    const auto& bench = workbench_.bench.bench();
    for (const EditField& field : fieldsOf(edit.parameters)) {
        if (!bench || !std::holds_alternative<double>(field.value)) continue;
        if (field.key == "low_mm") setField(edit.parameters, field.key, bench->setup.stock.low.z);
        if (field.key == "high_mm") setField(edit.parameters, field.key, bench->safeHeight());
    }
    return edit;
}

/// Whether what is being drawn has still the place that it was begun for.
bool PathScenePresenter::stillMeant() const {
    if (!field_) return workbench_.path.selection().has_value();
    const StoredPath* path = workbench_.path.stored();
    return path != nullptr && field_->edit < path->edits.size() && keyOf(*path, field_->edit) == drawnFor_;
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
    if (drawing_ && (!active || !stillMeant())) setDrawing(false);
    showOutlines();
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
    if (drawing_ && !drawn_.empty()) { // what is under way stays in sight, whatever is evaluated meanwhile
        showDrawing(drawn_);
        return;
    }
    PlaceChains chosen;
    const auto& selection = workbench_.path.selection();
    bool goesOn = false; // what lies between two chosen stretches is not chosen
    for (std::size_t i = 0; path_ && selection && i < path_->path.points.size(); ++i) {
        const bool here = isOfTheHand(path_->path.points[i]) && selection->contains(momentOf(i));
        if (here && !goesOn) chosen.emplace_back();
        if (here) chosen.back().push_back(path_->path.points[i].tip);
        goesOn = here;
    }
    viewport_.setMoveMark(chosen);
}

void PathScenePresenter::showDrag(std::size_t place, const glm::dvec3& by) {
    if (path_) viewport_.setMoveMark({Falloff(path_->path.points, place, by).places()});
}

void PathScenePresenter::drop(std::size_t place, const glm::dvec3& by) {
    if (!path_) return;
    workbench_.path.movePlace(momentOf(place), by,
                              drag_ == DragChoice::surface ? MovePoints::Along::surface : MovePoints::Along::free);
}

void PathScenePresenter::showDrawing(const std::vector<glm::dvec3>& places) {
    drawn_ = places;
    viewport_.setMoveMark({drawsArea() ? closed(places) : places});
}

void PathScenePresenter::finishDrawing(const std::vector<glm::dvec3>& places) {
    const std::optional<DrawnField> field = stillMeant() ? field_ : std::nullopt;
    const bool lost = field_ && !field;
    setDrawing(false);
    if (lost) return;
    const StoredPath* path = workbench_.path.stored();
    if (!field) {
        workbench_.path.replaceSelection(places);
    } else if (path != nullptr && field->edit < path->edits.size()) {
        Edit edit = path->edits[field->edit];
        setField(edit.parameters, field->key, places);
        workbench_.path.changeEdit(field->edit, edit);
    }
}

bool PathScenePresenter::drawsArea() const {
    return field_ && field_->key == areaKey;
}

/// Where areas are, and the guides that were drawn.
void PathScenePresenter::showOutlines() {
    PlaceChains lines;
    if (active_ && workbench_.path.stored() != nullptr)
        for (const Edit& edit : workbench_.path.stored()->edits)
            for (const EditField& field : fieldsOf(edit.parameters))
                if (const auto* places = std::get_if<std::vector<glm::dvec3>>(&field.value);
                    places && edit.enabled && !std::holds_alternative<ReplaceStretch>(edit.parameters))
                    lines.push_back(field.key == areaKey ? closed(*places) : *places);
    viewport_.setOutlines(lines);
}

Moment PathScenePresenter::momentOf(std::size_t place) const {
    const PathPoint& point = path_->path.points[place];
    return {point.take, point.sample};
}

/// Where a stretch of the path begins, or the middle height of all that cuts.
std::optional<double> PathScenePresenter::heightOf(const std::optional<TakeStretch>& stretch) const {
    if (!path_) return std::nullopt;
    std::vector<double> heights;
    for (std::size_t i = 0; i < path_->path.points.size(); ++i) {
        const PathPoint& point = path_->path.points[i];
        if (!isOfTheHand(point) || point.kind == MoveKind::rapid) continue;
        if (stretch && stretch->take != 0 && stretch->contains(momentOf(i))) return point.tip.z;
        heights.push_back(point.tip.z);
    }
    if (heights.empty()) return std::nullopt;
    const auto middle = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 2);
    std::ranges::nth_element(heights, middle);
    return *middle;
}

} // namespace burin
