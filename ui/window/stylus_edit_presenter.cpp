// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/stylus_edit_presenter.h"

#include "core/base/units.h"
#include "ui/panels/texts.h"
#include "ui/window/path_drag.h"

#include <cmath>

namespace burin {

namespace {

constexpr int reachCorners = 48;

/// The circle of points that are just in reach, at the height of the tip.
std::vector<glm::dvec3> reachCircle(const glm::dvec3& tip, double reach) {
    std::vector<glm::dvec3> circle;
    for (int i = 0; i <= reachCorners; ++i) {
        const double angle = 2.0 * pi * i / reachCorners;
        circle.push_back(tip + reach * glm::dvec3(std::cos(angle), std::sin(angle), 0.0));
    }
    return circle;
}

/// The path with its held point displaced.
std::vector<glm::dvec3> shapeOf(const EvaluatedPath& path, const PathGrip& grip, const glm::dvec3& by,
                                const StoredPath& stored) {
    const PathPlace place{grip.at.piece, grip.at.share};
    if (grip.insertedBy && *grip.insertedBy < stored.edits.size())
        if (const auto* edit = std::get_if<InsertPoint>(&stored.edits[*grip.insertedBy].parameters))
            return draggedShape(path.path.points, place, by, edit->length,
                                [edit](double way) { return way > 0.0 ? edit->shareAt(way) : 1.0; });
    const MovePoints edit;
    return draggedShape(path.path.points, place, by, edit.falloff, [&edit](double way) { return edit.shareAt(way); });
}

} // namespace

StylusEditPresenter::StylusEditPresenter(Workbench& workbench, PathPanel& panel, PathScenePresenter& scene,
                                         QObject* parent)
    : Presenter(
          workbench,
          {&workbench.stylusEditor, &workbench.path, &workbench.workpiece, &workbench.session, &workbench.styluses},
          parent)
    , panel_(panel)
    , scene_(scene) {
    StylusEditor& editor = workbench.stylusEditor;
    connect(&editor, &StylusEditor::entered, this, [this, &editor] {
        if (!shown_) return editor.leave();
        scene_.takeKeys();
        emit told(editor.usesMouse()
                      ? tr("Drag a point of the path: the tool goes with it, along part, fixtures and travel.")
                      : tr("Move the tool to the path, hold the device's first button to take the nearest point within "
                           "reach, and let go where it is to be."));
    });
    connect(&editor, &StylusEditor::refused, this, &StylusEditPresenter::told);
    connect(&editor, &StylusEditor::moved, this, &StylusEditPresenter::showMarks);
    connect(&editor, &StylusEditor::left, this, &StylusEditPresenter::showMarks);
    connect(&scene, &PathScenePresenter::changed, this, [this, &editor] {
        editor.setAlong(scene_.drag() == DragChoice::surface ? MovePoints::Along::surface : MovePoints::Along::free);
    });
    connect(&panel, &PathPanel::stylusRequested, this, &StylusEditPresenter::toggle);
    connect(&panel, &PathPanel::stylusReachEdited, &editor, &StylusEditor::setReach);
}

void StylusEditPresenter::setUnit(LengthUnit unit) {
    Presenter::setUnit(unit);
    presentSoon();
}

void StylusEditPresenter::setShown(JobStep step) {
    shown_ = step == JobStep::path;
    if (!shown_) workbench_.stylusEditor.leave();
}

void StylusEditPresenter::toggle(bool wanted) {
    wanted ? workbench_.stylusEditor.enter() : workbench_.stylusEditor.leave();
    presentSoon();
}

QString StylusEditPresenter::text() const {
    const StylusEditor& editor = workbench_.stylusEditor;
    if (!editor.active()) return {};
    if (!editor.path()) return tr("Wait until the path is up to date.");
    if (editor.held()) return tr("The point is moved by %1").arg(lengthText(glm::length(editor.by()), unit()));
    if (editor.usesMouse()) return tr("Drag a point of the path in the view");
    return editor.within() ? tr("A point is in reach, at %1").arg(lengthText(editor.within()->at.distance, unit()))
                           : tr("No point is in reach");
}

void StylusEditPresenter::present() {
    const StylusEditor& editor = workbench_.stylusEditor;
    StylusEditState state;
    state.active = editor.active();
    state.device = !editor.usesMouse();
    state.reach = editor.reach();
    state.leastReach = StylusEditor::smallestReach;
    state.mostReach = StylusEditor::largestReach;
    state.text = text();
    if (!state.active && !editor.possible())
        state.missing = workbench_.session.running()    ? tr("Leave mill mode first.")
                        : !workbench_.workpiece.ready() ? tr("Wait until the workpiece and the boundary are ready.")
                                                        : tr("Make a path first.");
    panel_.setStylusEdit(state, unit());
}

void StylusEditPresenter::showMarks() {
    const StylusEditor& editor = workbench_.stylusEditor;
    PlaceChains marks;
    const StoredPath* stored = workbench_.path.stored();
    if (editor.held() && editor.path() && stored != nullptr) {
        marks.push_back(shapeOf(*editor.path(), *editor.held(), editor.by(), *stored));
        marks.push_back({editor.held()->at.place + editor.by()});
    } else if (editor.active() && !editor.usesMouse()) {
        marks.push_back(reachCircle(editor.tip(), editor.reach()));
        if (editor.within()) marks.push_back({editor.within()->at.place});
        if (editor.within()) marks.push_back({editor.tip(), editor.within()->at.place});
    }
    scene_.setStylusMarks(marks);
    presentSoon();
}

} // namespace burin
