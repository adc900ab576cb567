// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/path_scene_presenter.h"

#include "core/geometry/arc.h"
#include "core/path/hand_interval.h"
#include "ui/panels/hand_times.h"
#include "ui/scene/camera_view.h"
#include "ui/window/context_menu.h"
#include "ui/window/path_drag.h"

#include <QMenu>

#include <algorithm>

namespace burin {

namespace {

constexpr double markedChord = 0.02; // mm, chord error of the mark of an arc

/// The points, and points on the arcs between them.
std::vector<glm::dvec3> drawnLine(const std::vector<PathPoint>& points) {
    std::vector<glm::dvec3> line, places;
    for (std::size_t i = 0; i < points.size(); ++i) {
        places.assign(1, points[i].pose.tip);
        if (i > 0 && points[i].arc) flatten(arcOf(points[i - 1].pose.tip, points[i]), markedChord, places);
        line.insert(line.end(), places.begin(), places.end());
    }
    return line;
}

} // namespace

PathScenePresenter::PathScenePresenter(Workbench& workbench, Viewport& viewport, QObject* parent)
    : Presenter(workbench, {&workbench.path, &workbench.mill, &workbench.stylusEditor}, parent)
    , viewport_(viewport)
    , hand_([&viewport](const glm::dvec3& place) { return viewport.project(place); }) {
    const auto showPreview = [this] {
        const PassPreview* preview = workbench_.passPreview.preview();
        viewport_.setPassPreview(preview != nullptr ? preview->strokes : PlaceChains{});
    };
    connect(&workbench.passPreview, &PassPreviewer::changed, this, showPreview);
    connect(&workbench.passShow, &PassShow::finished, this, showPreview);
    connect(&workbench.passShow, &PassShow::moved, this, [this] {
        if (const PassFilm::Picture* picture = workbench_.passShow.picture()) viewport_.setPassPreview(picture->lines);
    });
    connect(&workbench.time, &Controller::changed, this, &PathScenePresenter::followTime);
    connect(&workbench.time, &TimeController::momentChanged, this, &PathScenePresenter::followTime);
    connect(&hand_, &PathHand::chosen, this, [this](const PathPlace& place, bool extend) {
        clicked_ = {momentOf(place), insertionAt(path_->path.points, place.piece, place.share)};
        extend ? workbench_.path.selectTo(momentOf(place)) : workbench_.path.select(momentOf(place));
    });
    connect(&hand_, &PathHand::stateChanged, this, &PathScenePresenter::escapeChanged);
    connect(&hand_, &PathHand::dragging, this, &PathScenePresenter::showDrag);
    connect(&hand_, &PathHand::dropped, this, &PathScenePresenter::drop);
    connect(&hand_, &PathHand::handleDragging, this, &PathScenePresenter::showHandleDrag);
    connect(&hand_, &PathHand::handleDropped, this, [this](std::size_t handle, const glm::dvec3& by) {
        if (workbench_.stylusEditor.usesMouse())
            workbench_.stylusEditor.letGo();
        else if (handle < inserted_.size())
            workbench_.path.moveInserted(inserted_[handle].edit, by);
    });
    connect(&hand_, &PathHand::menuRequested, this, &PathScenePresenter::showMenu);
    connect(&hand_, &PathHand::drawing, this, &PathScenePresenter::showDrawing);
    connect(&hand_, &PathHand::drawn, this, &PathScenePresenter::finishDrawing);
    connect(&hand_, &PathHand::givenUp, this, [this] {
        drawn_.clear();
        if (workbench_.stylusEditor.usesMouse()) workbench_.stylusEditor.giveUp();
        markSelection();
    });
    connect(&hand_, &PathHand::escaped, this, &PathScenePresenter::escape);
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
    takeInserted();
    emit changed();
}

void PathScenePresenter::addEdit(const Edit& edit) {
    if (std::holds_alternative<InsertPoint>(edit.parameters) && workbench_.path.selection()) return insertAtSelection();
    const std::size_t place = workbench_.path.addEdit(withinStock(edit));
    const StoredPath* path = workbench_.path.stored();
    if (path == nullptr || place >= path->edits.size()) return; // refused
    for (const EditField& field : fieldsOf(edit.parameters))
        if (const auto* places = std::get_if<std::vector<glm::dvec3>>(&field.value); places && places->empty())
            setFieldDrawing({place, std::string(field.key)}, true);
}

void PathScenePresenter::lookAt(const glm::dvec3& place) {
    CameraView view = viewport_.cameraView();
    view.focus = place;
    viewport_.setCameraView(view);
    lookedAt_ = place;
    workbench_.path.pointAt(path_ ? momentNear(path_->path, place) : Moment{});
    markSelection();
}

void PathScenePresenter::insertAtSelection() {
    const std::optional<SourceInterval>& selection = workbench_.path.selection();
    if (!selection || !path_) return;
    InsertPoint edit;
    edit.at = {selection->source, selection->first};
    workbench_.path.insertPoint(clicked_.first == edit.at ? clicked_.second : edit);
}

/// The menu of a point of the path.
void PathScenePresenter::showMenu(const PathPlace& place, const QPointF& position) {
    if (!path_) return;
    const InsertPoint edit = insertionAt(path_->path.points, place.piece, place.share);
    const Moment moment = momentOf(place);
    const QString title = moment.source == 0 ? tr("Computed point") : momentText(workbench_.mill.allTakes(), moment);
    QMenu* menu = makeContextMenu("pathPointMenu", title, &viewport_);
    addEntry(*menu, tr("&Insert a point here"),
             tr("Insert a point into the path here. Drag it to move it; the stroke follows it smoothly."),
             "insertPointHere", [this, edit] { workbench_.path.insertPoint(edit); });
    menu->actions().back()->setEnabled(edit.at.source != 0); // an edit finds its position by a moment
    addEntry(*menu, tr("Show this &moment"), tr("Go to the time on the timeline at which this point was milled."),
             "showMomentHere", [this, moment] { workbench_.time.goTo(moment); });
    menu->actions().back()->setEnabled(workbench_.time.possible() && workbench_.time.secondsAt(moment).has_value());
    menu->popup(viewport_.mapToGlobal(position.toPoint()));
}

/// Initially an area extends from the stock's bottom to the height of free travel, and a mirror is in the middle of the
/// stock.
Edit PathScenePresenter::withinStock(Edit edit) const {
    const auto& milling = workbench_.workpiece.milling();
    for (const EditField& field : fieldsOf(edit.parameters)) {
        if (!milling || !std::holds_alternative<double>(field.value)) continue;
        if (field.key == "low_mm") setField(edit.parameters, field.key, milling->setup.stock.low.z);
        if (std::holds_alternative<Mirror>(edit.parameters) && isDrawn(edit.parameters, field.key))
            setField(edit.parameters, field.key, milling->setup.stock.centre().x);
        if (field.key == "high_mm") setField(edit.parameters, field.key, milling->safeHeight());
    }
    return edit;
}

void PathScenePresenter::present() {
    const bool active = shown_ && workbench_.path.evaluated() && !workbench_.mill.active();
    if (active != active_) {
        active_ = active;
        // In mill mode the pointer belongs to milling.
        if (active || !workbench_.mill.active()) viewport_.setInteractiveTool(active ? &hand_ : nullptr);
        if (!active) viewport_.setMoveMark({});
    }
    takePath();
    takeInserted();
    shownPlace_ = placeOnPath();
    if (!workbench_.path.pointsElsewhere()) lookedAt_.reset();
    hand_.setChosen(active_ && workbench_.path.pointed().has_value());
    hand_.setEscape(!workbench_.stylusEditor.active() ? QString()
                    : workbench_.stylusEditor.held()  ? tr("Esc: leave the point where it was")
                                                      : tr("Esc: put the stylus down"));
    if (drawing_ && (!active || !stillMeant())) setDrawing(false);
    showOutlines();
    if (active_) markSelection();
}

void PathScenePresenter::takePath() {
    const auto path = active_ ? workbench_.path.evaluated() : nullptr;
    if (path == path_) return;
    path_ = path;
    std::vector<HandPoint> points;
    if (path_)
        for (const PathPoint& point : path_->path.points) {
            const bool usable = hasMoment(point) && point.kind != MoveKind::rapid;
            const glm::dvec3 from = points.empty() ? point.pose.tip : points.back().place;
            points.push_back({point.pose.tip, usable, point.arc ? std::optional(arcOf(from, point)) : std::nullopt});
        }
    hand_.setPoints(std::move(points));
}

/// The points that edits inserted, as long as the path is that of the present edits.
void PathScenePresenter::takeInserted() {
    inserted_.clear();
    const StoredPath* path = workbench_.path.stored();
    if (path_ && path != nullptr && !workbench_.path.outdated()) inserted_ = insertedPoints(*path_, path->edits);
    std::vector<glm::dvec3> handles;
    if (drag_ != DragChoice::surface) // on the surface, the path itself is dragged
        for (const InsertedPoint& point : inserted_) handles.push_back(point.place);
    hand_.setHandles(std::move(handles));
}

void PathScenePresenter::markSelection() {
    if (drawing_ && !drawn_.empty()) { // the drawing under way stays visible, even if the path is evaluated meanwhile
        showDrawing(drawn_);
        return;
    }
    marks_.clear();
    if (lookedAt_)
        marks_.push_back({*lookedAt_});
    else
        for (const std::vector<PathPoint>& chain : chosenPoints()) marks_.push_back(drawnLine(chain));
    for (const InsertedPoint& point : inserted_) marks_.push_back({point.place});
    if (shownPlace_) marks_.push_back({*shownPlace_});
    drawMarks();
}

void PathScenePresenter::setStylusMarks(const PlaceChains& marks) {
    if (marks == stylusMarks_) return;
    stylusMarks_ = marks;
    if (active_ && drawn_.empty()) drawMarks();
}

void PathScenePresenter::drawMarks() {
    PlaceChains all = marks_;
    all.insert(all.end(), stylusMarks_.begin(), stylusMarks_.end());
    viewport_.setMoveMark(all);
}

/// @return false: the pointer moves the point by itself
bool PathScenePresenter::leadStylus(const PathGrip& grip, const glm::dvec3& by) {
    if (!workbench_.stylusEditor.usesMouse()) return false;
    workbench_.stylusEditor.lead(grip, by);
    return true;
}

void PathScenePresenter::escape() {
    StylusEditor& editor = workbench_.stylusEditor;
    editor.held() ? editor.giveUp() : editor.leave();
}

/// The point of the path at the time on the timeline.
std::optional<glm::dvec3> PathScenePresenter::placeOnPath() const {
    const std::optional<Moment> moment = workbench_.time.handMoment();
    return moment && path_ ? placeAt(path_->path, *moment, workbench_.time.handTip()) : std::nullopt;
}

void PathScenePresenter::followTime() {
    if (!active_) return;
    const std::optional<glm::dvec3> place = placeOnPath();
    if (place == shownPlace_) return;
    shownPlace_ = place;
    markSelection();
}

void PathScenePresenter::showHandleDrag(std::size_t handle, const std::optional<PathPlace>& place,
                                        const glm::dvec3& by) {
    const StoredPath* path = workbench_.path.stored();
    if (!path_ || path == nullptr || handle >= inserted_.size()) return;
    const InsertedPoint& point = inserted_[handle];
    const PathPlace on = place.value_or(PathPlace{});
    if (leadStylus({{on.piece, on.share, point.place, 0.0}, point.edit}, by)) return;
    const auto* edit = std::get_if<InsertPoint>(&path->edits[point.edit].parameters);
    if (edit == nullptr) return;
    PlaceChains shape{{point.place + by}};
    if (place)
        shape.push_back(draggedShape(path_->path.points, *place, by, edit->length,
                                     [edit](double way) { return way > 0.0 ? edit->shareAt(way) : 1.0; }));
    viewport_.setMoveMark(shape);
}

void PathScenePresenter::showDrag(const PathPlace& place, const glm::dvec3& by) {
    const MovePoints edit;
    if (path_ && leadStylus({{place.piece, place.share, placeOf(path_->path.points, place), 0.0}, std::nullopt}, by))
        return;
    if (path_)
        viewport_.setMoveMark({draggedShape(path_->path.points, place, by, edit.falloff,
                                            [&edit](double way) { return edit.shareAt(way); })});
}

void PathScenePresenter::drop(const PathPlace& place, const glm::dvec3& by) {
    if (workbench_.stylusEditor.usesMouse()) return workbench_.stylusEditor.letGo();
    if (!path_) return;
    workbench_.path.movePlace(momentOf(place), by,
                              drag_ == DragChoice::surface ? MovePoints::Along::surface : MovePoints::Along::free);
}

std::vector<std::vector<PathPoint>> PathScenePresenter::chosenPoints() const {
    const auto& selection = workbench_.path.selection();
    if (!path_ || !selection) return {};
    return pointsOf(path_->path, *selection);
}

Moment PathScenePresenter::momentOf(const PathPlace& place) const {
    return momentAt(path_->path.points[place.piece], path_->path.points[place.piece + 1], place.share);
}

} // namespace burin
