// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/measure_presenter.h"

#include "ui/panels/measure_labels.h"

#include <QAction>

#include <utility>

namespace burin {

MeasurePresenter::MeasurePresenter(Workbench& workbench, Viewport& viewport, QObject* parent)
    : Presenter(workbench,
                {&workbench.measure, &workbench.setup, &workbench.model, &workbench.mill, &workbench.workpiece,
                 &workbench.time},
                parent)
    , viewport_(viewport)
    , workpiecePicker_([&viewport] { return viewport.workpiece(); }) {
    connect(&picker_, &FacePicker::chosen, this,
            [this](std::size_t, const glm::dvec3& place) { workbench_.measure.pick(place); });
    connect(&workpiecePicker_, &WorkpiecePicker::chosen, this,
            [this](const glm::dvec3& place, const glm::dvec3& direction) {
                workbench_.measure.pickOnWorkpiece(viewport_.workpiece(), {place, direction});
            });
    connect(&picker_, &FacePicker::cancelled, this, [this] { ask(Target::none); });
    connect(&workpiecePicker_, &WorkpiecePicker::cancelled, this, [this] { ask(Target::none); });
    // Another tool took the pointer: milling, picking, painting.
    connect(&viewport, &Viewport::interactiveToolChanged, this, [this] {
        if (asking_ != Target::none && viewport_.interactiveTool() != pickerOf(asking_)) ask(Target::none);
    });
}

void MeasurePresenter::connectActions(const Actions& actions) {
    action_ = actions[ActionId::measure];
    workpieceAction_ = actions[ActionId::measureWorkpiece];
    connect(action_, &QAction::triggered, this, [this](bool on) { ask(on ? Target::part : Target::none); });
    connect(workpieceAction_, &QAction::triggered, this,
            [this](bool on) { ask(on ? Target::workpiece : Target::none); });
    presentSoon();
}

InteractiveTool* MeasurePresenter::pickerOf(Target target) {
    if (target == Target::none) return nullptr;
    return target == Target::part ? static_cast<InteractiveTool*>(&picker_) : &workpiecePicker_;
}

bool MeasurePresenter::possible(Target target) const {
    if (workbench_.model.preview() || workbench_.mill.active()) return false;
    return target == Target::part ? workbench_.setup.hasPart() : workbench_.workpiece.embedded();
}

void MeasurePresenter::ask(Target wanted) {
    if (wanted == asking_) return;
    if (wanted != Target::none && !possible(wanted)) {
        presentSoon();
        return;
    }
    const Target before = std::exchange(asking_, wanted);
    workbench_.measure.clear();
    if (wanted != Target::none) {
        if (before == Target::none) before_ = viewport_.interactiveTool();
        viewport_.setInteractiveTool(pickerOf(wanted));
        emit told(wanted == Target::part
                      ? tr("Click a point on the part to measure its face, then another one for the distance. Esc ends "
                           "measuring.")
                      : tr("Click a point on the workpiece to measure its face and the stock that is left there, then "
                           "another one for the distance. Esc ends measuring."));
    } else if (viewport_.interactiveTool() == pickerOf(before)) {
        viewport_.setInteractiveTool(std::exchange(before_, nullptr));
    }
    viewport_.setPartSeen(wanted == Target::part);
    presentSoon();
}

void MeasurePresenter::setOtherMark(const std::optional<MeasureMark>& mark) {
    other_ = mark;
    presentSoon();
}

void MeasurePresenter::present() {
    picker_.setModel(possible(Target::part) ? workbench_.setup.part() : nullptr);
    if (asking_ != Target::none && !possible(asking_)) ask(Target::none);
    if (asking_ == Target::workpiece && workbench_.measure.outdated(viewport_.workpiece())) workbench_.measure.clear();
    enableActions();
    tellResults();
}

void MeasurePresenter::enableActions() {
    if (action_ == nullptr) return;
    action_->setEnabled(possible(Target::part));
    action_->setChecked(asking_ == Target::part);
    workpieceAction_->setEnabled(possible(Target::workpiece));
    workpieceAction_->setChecked(asking_ == Target::workpiece);
}

void MeasurePresenter::tellResults() {
    const std::shared_ptr<const PartMeasure> part = workbench_.measure.measure();
    const std::shared_ptr<const WorkpieceMeasure> workpiece = workbench_.measure.workpieceMeasure();
    viewport_.setMeasureMark(part        ? std::optional(markOf(*part))
                             : workpiece ? std::optional(markOf(*workpiece))
                                         : other_);
    const glm::dvec3 zero = workbench_.setup.setup().workOffset;
    if (std::exchange(told_, part) != part && part) emit told(measureText(*part, zero, unit()));
    if (std::exchange(toldWorkpiece_, workpiece) != workpiece && workpiece)
        emit told(measureText(*workpiece, zero, unit()));
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

MeasureMark MeasurePresenter::markOf(const WorkpieceMeasure& measure) const {
    MeasureMark mark;
    mark.text = mainFigure(measure, unit());
    const MeasuredFace& from = measure.from.face;
    mark.lines.push_back({from.place});
    mark.place = from.place;
    if (measure.to) {
        mark.lines.push_back({measure.to->face.place});
        mark.lines.push_back({from.place, measure.to->face.place});
        mark.place = 0.5 * (from.place + measure.to->face.place);
    } else if (from.radius > 0.0) { // the radius
        const double out = glm::dot(from.axisPlace - from.place, from.normal) < 0.0 ? -1.0 : 1.0;
        mark.lines.push_back({from.place, from.place + out * from.radius * from.normal});
    } else if (from.thickness) {
        mark.lines.push_back({from.place, from.place - *from.thickness * from.normal});
    }
    return mark;
}

} // namespace burin
