// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/setups_presenter.h"

#include "core/base/units.h"
#include "core/setup/face_alignment.h"
#include "ui/dialogs/setup_dialog.h"

#include <algorithm>
#include <utility>

namespace burin {

namespace {

glm::dvec3 directionOf(FaceAim aim) {
    switch (aim) {
    case FaceAim::down:
        return {0.0, 0.0, -1.0};
    case FaceAim::alongX:
        return {1.0, 0.0, 0.0};
    case FaceAim::alongY:
        return {0.0, 1.0, 0.0};
    case FaceAim::up:
    case FaceAim::none:
        break;
    }
    return {0.0, 0.0, 1.0};
}

} // namespace

SetupsPresenter::SetupsPresenter(Workbench& workbench, Viewport& viewport, SetupPanel& panel, QObject* parent)
    : Presenter(workbench, {&workbench.setups, &workbench.setup, &workbench.model, &workbench.workpiece}, parent)
    , viewport_(viewport)
    , panel_(panel) {
    connect(&panel, &SetupPanel::setupChosen, &workbench.setups,
            [&workbench](qint64 number) { workbench.setups.use(SetupId{number}); });
    connect(&panel, &SetupPanel::additionRequested, this, &SetupsPresenter::add);
    connect(&panel, &SetupPanel::removalRequested, &workbench.setups, &SetupsController::remove);
    connect(&panel, &SetupPanel::named, &workbench.setups, &SetupsController::rename);
    connect(&panel, &SetupPanel::stockRequested, &workbench.setups, &SetupsController::takeStockAnew);
    connect(&panel, &SetupPanel::turned, this, &SetupsPresenter::turn);
    connect(&panel, &SetupPanel::positioned, this, [this](int axis, double place) {
        if (!workbench_.setup.part()) return;
        glm::dvec3 by(0.0);
        by[axis] = place - workbench_.setup.part()->box().low[axis];
        workbench_.setup.place(movedBy(by));
    });
    connect(&panel, &SetupPanel::mirrored, &workbench.model, &ModelController::mirror);
    connect(&panel, &SetupPanel::facePickRequested, this, &SetupsPresenter::pick);
    connect(&picker_, &FacePicker::chosen, this, [this](std::size_t, const glm::dvec3& point) { turnTo(point); });
    connect(&picker_, &FacePicker::cancelled, this, &SetupsPresenter::leave);
}

void SetupsPresenter::connectActions(const Actions& actions) {
    connect(actions[ActionId::addSetup], &QAction::triggered, this, &SetupsPresenter::add);
    connect(actions[ActionId::nextSetup], &QAction::triggered, this, [this] { step(1); });
    connect(actions[ActionId::previousSetup], &QAction::triggered, this, [this] { step(-1); });
    connect(actions[ActionId::faceDown], &QAction::triggered, this, [this] { pick(FaceAim::down); });
    const std::array turns{ActionId::turnAboutX, ActionId::turnAboutY, ActionId::turnAboutZ};
    for (std::size_t axis = 0; axis < turns.size(); ++axis)
        connect(actions[turns[axis]], &QAction::triggered, this,
                [this, axis] { turn(static_cast<int>(axis), 0.5 * pi); });
}

void SetupsPresenter::setUnit(LengthUnit unit) {
    panel_.setUnit(unit);
    Presenter::setUnit(unit);
}

void SetupsPresenter::present() {
    const SetupController& setup = workbench_.setup;
    picker_.setModel(setup.part());
    SetupState state;
    if (!workbench_.model.preview()) state.part = setup.part();
    for (const SetupName& name : workbench_.setups.setups())
        state.setups.push_back({name.id, QString::fromStdString(name.name), workbench_.setups.title(name.id)});
    state.used = workbench_.setups.used();
    state.placement = setup.setup().placement;
    state.stockOutOfDate = workbench_.setups.stockOutOfDate();
    state.embedded = workbench_.workpiece.embedded();
    state.locked = setup.locked();
    state.busy = workbench_.setups.adding() || setup.placing();
    state.aim = aim_;
    panel_.setState(state);
}

void SetupsPresenter::add() {
    const std::shared_ptr<const Model>& part = workbench_.setup.part();
    if (!part || workbench_.setups.adding()) return;
    const auto number = static_cast<int>(workbench_.setups.setups().size()) + 1;
    const auto wanted =
        askSetup(panel_.window(), tr("Setup %1").arg(number), part->box().centre(), workbench_.workpiece.embedded());
    if (wanted) workbench_.setups.add(wanted->name, wanted->turn, wanted->leftStock);
}

void SetupsPresenter::step(int by) {
    const std::vector<SetupName>& setups = workbench_.setups.setups();
    const auto own = std::ranges::find(setups, workbench_.setups.used(), &SetupName::id);
    const auto wanted = (own - setups.begin()) + by;
    if (wanted < 0 || wanted >= static_cast<std::ptrdiff_t>(setups.size())) return;
    workbench_.setups.use(setups[static_cast<std::size_t>(wanted)].id);
}

void SetupsPresenter::pick(FaceAim aim) {
    if (aim != FaceAim::none && (workbench_.setup.locked() || !workbench_.setup.part())) return;
    if (aim != FaceAim::none && aim_ == FaceAim::none) {
        emit pickBegins();
        before_ = viewport_.interactiveTool();
        viewport_.setInteractiveTool(&picker_);
    }
    if (aim == FaceAim::none && viewport_.interactiveTool() == &picker_)
        viewport_.setInteractiveTool(std::exchange(before_, nullptr));
    aim_ = aim;
    presentSoon();
}

void SetupsPresenter::turnTo(const glm::dvec3& place) {
    const FaceAim aim = aim_;
    // Queued: the mouse press is still being handled.
    QMetaObject::invokeMethod(this, &SetupsPresenter::leave, Qt::QueuedConnection);
    workbench_.setup.examineFace(place, [this, aim](const PartFace& face) { align(aim, face); });
}

void SetupsPresenter::align(FaceAim aim, const PartFace& face) {
    if (!workbench_.setup.part()) return;
    const glm::dvec3 middle = workbench_.setup.part()->box().centre();
    const Result<Placement> turn = alignedFace(face, directionOf(aim), middle);
    if (turn)
        workbench_.setup.place(*turn);
    else
        emit refused(tr("This face is curved and has no direction. Click a plane, a cylinder or a cone."));
}

void SetupsPresenter::turn(int axis, double angle) {
    if (!workbench_.setup.part()) return;
    glm::dvec3 direction(0.0);
    direction[axis] = 1.0;
    workbench_.setup.place(turnedAbout(direction, angle, workbench_.setup.part()->box().centre()));
}

} // namespace burin
