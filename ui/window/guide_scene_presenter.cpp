// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/guide_scene_presenter.h"

#include "ui/panels/guide_labels.h"

#include <algorithm>

namespace burin {

namespace {

constexpr double beyondStock = 0.04;  // of the stock's longest side: guides extend beyond it
constexpr double framePeriod = 0.016; // s: the rate at which the session is polled

Box roomAround(const Box& stock) {
    const glm::dvec3 size = stock.size();
    return stock.grown(beyondStock * std::max({size.x, size.y, size.z}));
}

} // namespace

GuideScenePresenter::GuideScenePresenter(Workbench& workbench, Viewport& viewport, const Actions& actions,
                                         QObject* parent)
    : Presenter(workbench,
                {&workbench.guides, &workbench.workpiece, &workbench.mill, &workbench.setup, &workbench.showMe}, parent)
    , viewport_(viewport)
    , actions_(actions) {
    connect(&workbench.session, &SessionRunner::ticked, this, &Presenter::presentSoon);
    connect(&workbench.session, &SessionRunner::traced, this, &GuideScenePresenter::follow);
    connect(&workbench.mill, &MillController::entered, this, &GuideScenePresenter::forgetPass);
    connect(&workbench.mill, &MillController::left, this, &GuideScenePresenter::forgetPass);
    connect(&workbench.guides, &GuideController::levelStepped, this, [this] { pass_.finish(); });
    connect(actions[ActionId::showGuides], &QAction::toggled, this, &Presenter::presentSoon);
}

void GuideScenePresenter::setShown(JobStep step) {
    step_ = step;
    presentSoon();
}

/// The loop keeps its last pass as long as it runs, and so does this presenter.
void GuideScenePresenter::forgetPass() {
    pass_.forget();
    lastPass_.reset();
    leaning_.forget();
}

void GuideScenePresenter::follow(const std::vector<TracePoint>& points) {
    for (const TracePoint& point : points) {
        if (point.strokeBegins) pass_.finish();
        pass_.add(glm::dvec3(point.tip));
    }
}

void GuideScenePresenter::keepPass() {
    const std::vector<Guide>& guides = workbench_.guides.guides();
    const auto stepOver = std::ranges::find(guides, GuideKind::stepOver, &Guide::kind);
    const glm::dvec3 direction = stepOver == guides.end() ? glm::dvec3(0.0, 0.0, 1.0) : stepOver->direction;
    if (std::exchange(passDirection_, direction) != direction) forgetPass(); // the same as in the loop
    if (!workbench_.session.state().cutting) pass_.finish();
    if (pass_.number() == passNumber_) return;
    passNumber_ = pass_.number();
    lastPass_ = std::make_shared<const std::vector<glm::dvec3>>(pass_.points().begin(), pass_.points().end());
}

GuideMark GuideScenePresenter::markOf(std::size_t place) {
    const MillingContext& milling = *workbench_.workpiece.milling();
    GuideMark mark;
    mark.guide = workbench_.guides.guides()[place];
    const bool live = workbench_.mill.active();
    if (live) {
        const GuideNews& news = workbench_.session.state().guides[place];
        mark.holds = news.is == GuideNews::Is::holding;
        mark.level = news.level;
    }
    mark.label = (mark.holds ? QStringLiteral("● ") : QStringLiteral("○ ")) +
                 guideLine(mark.guide, milling.setup.workOffset, unit());
    if (live && mark.guide.kind == GuideKind::axis) lean(mark);
    return mark;
}

void GuideScenePresenter::lean(GuideMark& mark) {
    const std::shared_ptr<const ClearanceField> field = workbench_.workpiece.field();
    if (!field) return;
    const ToolPose& tool = workbench_.session.state().sample.proxy;
    mark.axis = leaning_.lean(&mark.guide, *field, tool, tool.tip, framePeriod);
    if (!mark.guide.onSurface) return;
    const FieldSample sample = field->at(tool.tip);
    if (sample.fine && glm::length(sample.gradient) > 0.0) mark.guide.direction = glm::normalize(sample.gradient);
}

void GuideScenePresenter::present() {
    keepPass();
    GuideMarks marks;
    const bool wanted = actions_[ActionId::showGuides]->isChecked() && workbench_.guides.on() &&
                        workbench_.workpiece.embedded() && !workbench_.showMe.showing() &&
                        (step_ == JobStep::mill || workbench_.mill.active());
    if (wanted) {
        const MillingContext& milling = *workbench_.workpiece.milling();
        marks.room = roomAround(milling.setup.stock);
        marks.tips = milling.tipRegion();
        if (workbench_.workpiece.fieldComplete()) marks.field = workbench_.workpiece.field();
        marks.lastPass = lastPass_;
        const std::vector<Guide>& guides = workbench_.guides.guides();
        for (std::size_t i = 0; i < guides.size(); ++i)
            if (guides[i].on) marks.guides.push_back(markOf(i));
    }
    viewport_.setGuides(marks);
}

} // namespace burin
