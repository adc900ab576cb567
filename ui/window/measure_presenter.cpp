// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/measure_presenter.h"

#include "ui/panels/measure_labels.h"

#include <QAction>

#include <utility>

namespace burin {

MeasurePresenter::MeasurePresenter(Workbench& workbench, Viewport& viewport, QObject* parent)
    : Presenter(workbench, {&workbench.measure, &workbench.setup, &workbench.model, &workbench.mill}, parent)
    , viewport_(viewport) {
    connect(&picker_, &FacePicker::chosen, this,
            [this](std::size_t, const glm::dvec3& place) { workbench_.measure.pick(place); });
    connect(&picker_, &FacePicker::cancelled, this, [this] { ask(false); });
    // Another tool took the pointer: milling, picking, painting.
    connect(&viewport, &Viewport::interactiveToolChanged, this, [this] {
        if (asking_ && viewport_.interactiveTool() != &picker_) ask(false);
    });
}

void MeasurePresenter::connectActions(const Actions& actions) {
    action_ = actions[ActionId::measure];
    connect(action_, &QAction::triggered, this, &MeasurePresenter::ask);
    presentSoon();
}

void MeasurePresenter::ask(bool wanted) {
    if (wanted == asking_) return;
    if (wanted && (!workbench_.setup.hasPart() || workbench_.model.preview() || workbench_.mill.active())) {
        presentSoon();
        return;
    }
    asking_ = wanted;
    if (wanted) {
        before_ = viewport_.interactiveTool();
        viewport_.setInteractiveTool(&picker_);
        emit told(tr(
            "Click a point on the part to measure its face, then another one for the distance. Esc ends measuring."));
    } else {
        if (viewport_.interactiveTool() == &picker_) viewport_.setInteractiveTool(std::exchange(before_, nullptr));
        workbench_.measure.clear();
    }
    viewport_.setPartSeen(wanted);
    presentSoon();
}

void MeasurePresenter::setOtherMark(const std::optional<MeasureMark>& mark) {
    other_ = mark;
    presentSoon();
}

void MeasurePresenter::present() {
    const bool possible = workbench_.setup.hasPart() && !workbench_.model.preview() && !workbench_.mill.active();
    picker_.setModel(possible ? workbench_.setup.part() : nullptr);
    if (asking_ && !possible) ask(false);
    if (action_ != nullptr) {
        action_->setEnabled(possible);
        action_->setChecked(asking_);
    }
    const std::shared_ptr<const PartMeasure> measure = workbench_.measure.measure();
    viewport_.setMeasureMark(measure ? std::optional(markOf(*measure)) : other_);
    if (std::exchange(told_, measure) != measure && measure)
        emit told(measureText(*measure, workbench_.setup.setup().workOffset, unit()));
}

MeasureMark MeasurePresenter::markOf(const PartMeasure& measure) const {
    MeasureMark mark;
    mark.text = mainFigure(measure, unit());
    const MeasuredFace& from = measure.from;
    mark.lines.push_back({from.place});
    mark.place = from.place;
    if (!measure.to) {
        if (from.thickness) mark.lines.push_back({from.place, from.place - *from.thickness * from.normal});
        return mark;
    }
    mark.lines.push_back({measure.to->place});
    mark.lines.push_back({from.place, measure.to->place});
    mark.place = 0.5 * (from.place + measure.to->place);
    return mark;
}

} // namespace burin
