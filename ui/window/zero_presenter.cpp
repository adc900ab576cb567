// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/zero_presenter.h"

#include "core/job/touched_stock.h"
#include "core/nc/work_offset.h"
#include "ui/panels/guide_labels.h"
#include "ui/panels/quantity.h"

#include <utility>

namespace burin {

ZeroPresenter::ZeroPresenter(Workbench& workbench, Viewport& viewport, ZeroPanel& panel, QObject* parent)
    : Presenter(workbench, {&workbench.setup, &workbench.model}, parent), viewport_(viewport), panel_(panel) {
    connect(&panel, &ZeroPanel::zeroChosen, &workbench.setup, &SetupController::chooseZero);
    connect(&panel, &ZeroPanel::pickRequested, this, &ZeroPresenter::pick);
    connect(&picker_, &ZeroPicker::chosen, this, [this](std::size_t, const glm::dvec3& point) {
        end();
        workbench_.setup.examineFace(point, [this](const PartFace& face) { placeAt(face.corner); });
    });
    connect(&picker_, &ZeroPicker::stockChosen, this, &ZeroPresenter::placeOnStock);
    connect(&picker_, &ZeroPicker::cancelled, this, [this] { pick(false); });
}

void ZeroPresenter::connectActions(const Actions& actions) {
    connect(actions[ActionId::pickZero], &QAction::triggered, this, [this] { pick(true); });
    connect(actions[ActionId::touchZero], &QAction::triggered, this, &ZeroPresenter::touch);
    hold_ = actions[ActionId::holdAtStock];
    connect(hold_, &QAction::triggered, &workbench_.surroundings, &SurroundingsController::holdAtStock);
    connect(&workbench_.surroundings, &Controller::changed, this, &ZeroPresenter::showHold);
}

void ZeroPresenter::setUnit(LengthUnit unit) {
    panel_.setUnit(unit);
    Presenter::setUnit(unit);
}

void ZeroPresenter::setShown(JobStep step) {
    step_ = step;
    if (step != JobStep::stock) pick(false);
    presentSoon();
}

void ZeroPresenter::present() {
    const SetupController& setup = workbench_.setup;
    const bool hasPart = setup.hasPart() && !workbench_.model.preview();
    picker_.setModel(hasPart ? setup.part() : nullptr);
    picker_.setStock(setup.setup().stock);
    ZeroState state;
    state.hasPart = hasPart;
    state.zero = setup.setup().zero;
    state.place = setup.setup().workOffset;
    state.picking = picking_;
    panel_.setState(state);
    const bool marked = hasPart && !setup.problem() && step_ != JobStep::mill && step_ != JobStep::path;
    viewport_.setZero(
        marked ? std::optional(ZeroPlace{state.place, QString::fromStdString(workOffsetName(state.zero.workOffset))})
               : std::nullopt);
}

void ZeroPresenter::pick(bool wanted) {
    if (wanted == picking_ || (wanted && !workbench_.setup.usable())) return;
    if (wanted) {
        emit pickBegins();
        before_ = viewport_.interactiveTool();
        viewport_.setInteractiveTool(&picker_);
    } else if (viewport_.interactiveTool() == &picker_) {
        viewport_.setInteractiveTool(std::exchange(before_, nullptr));
    }
    picking_ = wanted;
    viewport_.setPartSeen(wanted);
    presentSoon();
}

/// Queued: the mouse press that sets the point is still being handled by the picker.
void ZeroPresenter::end() {
    QMetaObject::invokeMethod(
        this, [this] { pick(false); }, Qt::QueuedConnection);
}

void ZeroPresenter::placeOnStock(const std::array<BoxSide, 3>& sides) {
    end();
    ProgramZero zero = workbench_.setup.setup().zero;
    zero.on = ZeroReference::stock;
    zero.sides = sides;
    workbench_.setup.chooseZero(zero);
}

void ZeroPresenter::placeAt(const glm::dvec3& point) {
    ProgramZero zero = workbench_.setup.setup().zero;
    zero.on = ZeroReference::point;
    zero.point = point;
    workbench_.setup.chooseZero(zero);
}

void ZeroPresenter::touch() {
    const auto& milling = workbench_.workpiece.milling();
    if (!milling || !workbench_.session.running()) return;
    // The allowance grows the part alone; the stock is touched as it is.
    const auto stock = workbench_.surroundings.stockNews();
    const bool atStock =
        stock && stock->holds && workbench_.workpiece.bounds() && workbench_.workpiece.bounds()->stock();
    const TouchedFace touched =
        touchedFace(workbench_.session.state().sample, milling->tool, atStock ? 0.0 : workbench_.mill.allowance());
    if (touched.outcome == TouchedFace::Outcome::nothing)
        return emit refused(
            tr("The tool touches nothing. Hold it against a face of the part, or of the stock after “Stop the "
               "tool at the stock”."));
    if (touched.outcome == TouchedFace::Outcome::aslant)
        return emit refused(tr("Touching off needs a vertical tool and a face that is parallel to two axes."));
    if (atStock) return touchStock(touched);
    workbench_.setup.examineFace(touched.place, [this, touched](const PartFace& face) {
        const int axis = touched.axis;
        if (glm::distance(face.place, touched.place) > workbench_.setup.setup().voxel)
            return emit refused(tr("The tool does not touch the part. Hold it against a face of the part."));
        glm::dvec3 place = workbench_.setup.setup().workOffset;
        place[axis] = face.place[axis]; // the exact coordinate, without the error of the voxels
        placeAt(place);
    });
}

void ZeroPresenter::touchStock(const TouchedFace& touched) {
    const std::shared_ptr<const TouchableStock>& stock = workbench_.workpiece.bounds()->stock();
    const std::optional<TouchedSide> side = stock->sideTouched(touched, workbench_.workpiece.milling()->tool);
    if (!side) // an edge or a leaning side, or a fixture that holds the tool together with the stock
        return emit refused(
            tr("The tool doesn't touch a side of the stock squarely. Hold it against a side that is parallel to two "
               "axes, and against nothing else."));
    glm::dvec3 place = workbench_.setup.setup().workOffset;
    place[touched.axis] = side->coordinate;
    placeAt(place);
    if (side->error > 0.0)
        emit told(tr("Zero along %1 is set to the touched side, which is known to within %2.")
                      .arg(axisLetter(touched.axis), lengthText(side->error, unit())));
}

void ZeroPresenter::showHold() {
    hold_->setChecked(workbench_.surroundings.stockHolds());
}

} // namespace burin
