// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/gizmo_presenter.h"

#include "ui/panels/guide_labels.h"
#include "ui/panels/quantity.h"
#include "ui/scene/gizmo_geometry.h"

#include <QAction>

#include <utility>

namespace burin {

GizmoPresenter::GizmoPresenter(Workbench& workbench, Viewport& viewport, const PartPresenter& part,
                               const Actions& actions, QObject* parent)
    : Presenter(workbench,
                {&workbench.setup, &workbench.setups, &workbench.model, &workbench.fixtures, &workbench.mover,
                 &workbench.showMe},
                parent)
    , viewport_(viewport)
    , part_(part)
    , actions_(actions)
    , tool_(viewport) {
    viewport.setHandleTool(&tool_);
    connect(actions[ActionId::placementHandles], &QAction::toggled, this, &Presenter::presentSoon);
    connect(&viewport, &Viewport::interactiveToolChanged, this, &Presenter::presentSoon);
    connect(&tool_, &GizmoTool::litChanged, this, &GizmoPresenter::draw);
    connect(&tool_, &GizmoTool::began, this, &GizmoPresenter::begin);
    connect(&tool_, &GizmoTool::moved, this, &GizmoPresenter::follow);
    connect(&tool_, &GizmoTool::released, this, &GizmoPresenter::end);
    connect(&tool_, &GizmoTool::clicked, this, &GizmoPresenter::click);
    connect(&tool_, &GizmoTool::cancelled, this, &GizmoPresenter::giveUp);
}

GizmoPresenter::~GizmoPresenter() {
    viewport_.setHandleTool(nullptr);
}

void GizmoPresenter::setUnit(LengthUnit unit) {
    tool_.setUnit(unit);
    Presenter::setUnit(unit);
}

void GizmoPresenter::setShown(JobStep step) {
    step_ = step;
    presentSoon();
}

/// As for the numbers of the setup panel; while a face or a point is picked, the part must not be covered.
bool GizmoPresenter::partPlaceable() const {
    const SetupController& setup = workbench_.setup;
    return step_ == JobStep::part && part_.pointing() && setup.part() && !setup.part()->box().empty() &&
           !setup.locked() && !setup.placing() && !workbench_.setups.adding() && !workbench_.model.preview() &&
           !workbench_.showMe.showing();
}

std::optional<Gizmo> GizmoPresenter::gizmo() const {
    if (!actions_[ActionId::placementHandles]->isChecked()) return std::nullopt;
    if (workbench_.fixtures.placing()) return Gizmo{workbench_.fixtures.design().place, true};
    const ObstacleMover& mover = workbench_.mover;
    if (mover.moving()) return Gizmo{mover.centre(), false, mover.rotates()};
    if (!partPlaceable()) return std::nullopt;
    return Gizmo{workbench_.setup.part()->box().centre(), false};
}

void GizmoPresenter::present() {
    const std::shared_ptr<const Model>& part = workbench_.setup.part();
    const bool exchanged = tool_.dragging() && partDragged() && moving_ != part;
    const bool gone =
        tool_.dragging() && ((fixture_ && !workbench_.fixtures.placing()) || (obstacle_ && !workbench_.mover.moving()));
    if (exchanged || gone) tool_.cancel();
    // A placement that failed or was cancelled leaves the part where it was.
    if (moving_ && !tool_.dragging() && !workbench_.setup.placing()) {
        if (moving_ == part) viewport_.movePart({});
        moving_.reset();
    }
    const std::optional<Gizmo> wanted = gizmo();
    if (!wanted && tool_.dragging()) tool_.cancel();
    if (!tool_.dragging()) shown_ = wanted; // otherwise it goes with the pointer
    tool_.setGizmo(shown_);
    draw();
}

void GizmoPresenter::begin() {
    from_ = *shown_;
    fixture_.reset();
    obstacle_.reset();
    if (workbench_.fixtures.placing())
        fixture_ = workbench_.fixtures.design();
    else if (workbench_.mover.moving())
        obstacle_ = workbench_.mover.motion();
    else
        moving_ = workbench_.setup.part();
    if (partDragged() && workbench_.workpiece.embedded()) viewport_.setPartSeen(true);
    draw();
    emit escapeChanged();
}

Placement GizmoPresenter::placementOf(const GizmoHandle& handle, const GizmoMotion& motion) const {
    if (handle.part != GizmoPart::ring) return movedBy(motion.shift);
    return motion.angle == 0.0 ? Placement{} : turnedAbout(axisDirection(handle.axis), motion.angle, from_.centre);
}

/// "X +12.000 mm", "X +3.000 mm  Y −1.000 mm", "Z +30.00°"
QString GizmoPresenter::valueOf(const GizmoHandle& handle, const GizmoMotion& motion) const {
    const auto signedText = [](double value, const QString& text) {
        return value > 0.0 ? QLatin1Char('+') + text : text;
    };
    QStringList values;
    for (int axis = 0; axis < 3; ++axis) {
        if (handle.part == GizmoPart::square ? axis == handle.axis : axis != handle.axis) continue;
        const QString text = handle.part == GizmoPart::ring
                                 ? signedText(motion.angle, quantityText(motion.angle, Quantity::angle, unit()))
                                 : signedText(motion.shift[axis], lengthText(motion.shift[axis], unit()));
        values << axisLetter(axis) + QLatin1Char(' ') + text;
    }
    return values.join(QStringLiteral("   "));
}

void GizmoPresenter::follow(const GizmoHandle& handle, const GizmoMotion& motion) {
    if (obstacle_)
        workbench_.mover.setMotion(combined(*obstacle_, placementOf(handle, motion)));
    else if (!fixture_)
        viewport_.movePart(placementOf(handle, motion));
    else if (handle.part == GizmoPart::ring)
        workbench_.fixtures.setTurn(fixture_->turn + motion.angle);
    else
        workbench_.fixtures.setPlace(fixture_->place + motion.shift);
    shown_ = Gizmo{from_.centre + motion.shift, from_.upright, from_.rotates};
    mark_.value = valueOf(handle, motion);
    draw();
}

void GizmoPresenter::end(const GizmoHandle& handle, const GizmoMotion& motion) {
    follow(handle, motion);
    if (partDragged()) workbench_.setup.place(placementOf(handle, motion)); // does nothing if it is back where it was
    finish();
}

/// Handles don't hide from clicks what lies behind them: a body to be selected, the stock on which a fixture is placed.
void GizmoPresenter::click() {
    finish();
    InteractiveTool* tool = viewport_.interactiveTool();
    if (tool == nullptr) return;
    ViewportEvent event = viewport_.sight(tool_.pointer());
    event.button = Qt::LeftButton;
    event.buttons = Qt::LeftButton;
    tool->press(event);
    event.buttons = Qt::NoButton;
    tool->release(event);
}

void GizmoPresenter::giveUp() {
    if (obstacle_) {
        workbench_.mover.setMotion(*obstacle_);
    } else if (!fixture_) {
        viewport_.movePart({});
        moving_.reset();
    } else if (workbench_.fixtures.placing()) {
        workbench_.fixtures.setPlace(fixture_->place);
        workbench_.fixtures.setTurn(fixture_->turn);
    }
    finish();
}

void GizmoPresenter::finish() {
    if (partDragged()) viewport_.setPartSeen(false);
    mark_.value.clear();
    presentSoon();
    draw();
    emit escapeChanged();
}

void GizmoPresenter::draw() {
    if (!shown_) return viewport_.setGizmo(std::nullopt);
    mark_.gizmo = *shown_;
    mark_.lit = tool_.lit();
    mark_.pointer = tool_.pointer();
    viewport_.setGizmo(mark_);
}

} // namespace burin
