// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/face_presenter.h"

#include "ui/messages/messages.h"
#include "ui/scene/camera_view.h"
#include "ui/window/deviation_tolerance.h"
#include "ui/window/face_dialog.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin {

namespace {

constexpr double leastSight = 5.0;      // mm: least distance shown around a point
constexpr double leastFacing = 0.5;     // cosine between face normal and direction to the eye; below it the view turns
constexpr double leastElevation = 0.52; // rad: looks over the walls around a vertical face

/// Returns a view of a point from outside. It keeps the present orientation if that shows the face, and is never
/// farther away than the present view.
CameraView viewOnto(const WorstPoint& point, double reach, const CameraView& now, const QSizeF& size) {
    CameraView view = now;
    if (glm::dot(axesOf(view).back, point.outward) < leastFacing) {
        const double flat = std::hypot(point.outward.x, point.outward.y);
        if (flat > 1e-6) view.azimuth = std::atan2(point.outward.y, point.outward.x);
        view.elevation = std::atan2(point.outward.z, flat);
        if (view.elevation > -leastElevation) view.elevation = std::max(view.elevation, leastElevation);
    }
    Box around;
    around.include(point.place);
    view = fitted(view, size, around.grown(std::max(leastSight, reach)));
    view.distance = std::min(view.distance, now.distance);
    return view;
}

} // namespace

FacePresenter::FacePresenter(Workbench& workbench, Viewport& viewport, DeviationCard& card, QObject* parent)
    : Presenter(workbench, {&workbench.program, &workbench.mill, &workbench.workpiece, &workbench.faces}, parent)
    , viewport_(viewport)
    , card_(card) {
    connect(&workbench.tasks(), &TaskRunner::changed, this, &FacePresenter::showProgress);
}

void FacePresenter::connectActions(const Actions& actions) {
    QAction* action = actions[ActionId::inspectFaces];
    connect(action, &QAction::triggered, this, &FacePresenter::open);
    connect(&card_, &DeviationCard::facesRequested, action, &QAction::trigger);
    connect(action, &QAction::enabledChanged, &card_, &DeviationCard::setFacesPossible);
    card_.setFacesPossible(action->isEnabled());
}

void FacePresenter::setUnit(LengthUnit unit) {
    Presenter::setUnit(unit);
    if (dialog_) dialog_->setUnit(unit);
}

void FacePresenter::open() {
    if (!dialog_) {
        dialog_ = new FaceDialog(viewport_.window());
        dialog_->setUnit(unit());
        connect(dialog_, &FaceDialog::faceChosen, this, &FacePresenter::lookAt);
        connect(dialog_, &FaceDialog::cancelRequested, this, [this] { workbench_.tasks().cancel(TaskKind::faces); });
        connect(dialog_, &FaceDialog::exportRequested, this, &FacePresenter::exportRequested);
        connect(dialog_, &FaceDialog::closed, this, [this] {
            workbench_.faces.stop();
            emit marked({});
        });
    } else if (workbench_.faces.problem()) {
        workbench_.faces.stop(); // it failed or was cancelled, and is requested again
    }
    dialog_->show();
    dialog_->raise();
    dialog_->activateWindow();
    present();
}

void FacePresenter::present() {
    if (!dialog_ || !dialog_->isVisible()) return;
    const std::shared_ptr<const CheckedProgram> program = workbench_.program.upToDate();
    QString why;
    if (!program || program->report.deviations.empty()) {
        workbench_.faces.stop();
        why = tr("There is no checked program, or something has changed since; post and check it again.");
    } else {
        workbench_.faces.inspect(program, workbench_.workpiece.milling()->partModel, deviationTolerance(workbench_));
        if (const auto& problem = workbench_.faces.problem())
            why = problem->code == ErrorCode::cancelled ? tr("Cancelled; open the table again to inspect the faces.")
                                                        : Messages::sentence(*problem);
    }
    if (std::exchange(shown_, workbench_.faces.faces()) != workbench_.faces.faces()) emit marked({});
    dialog_->setFaces(shown_, why);
    showProgress();
}

void FacePresenter::showProgress() {
    if (!dialog_ || !dialog_->isVisible()) return;
    dialog_->setProgress(workbench_.faces.busy() ? std::optional(workbench_.faces.fraction()) : std::nullopt);
}

void FacePresenter::lookAt(const FaceQuality& face) {
    const WorstPoint& worst = worstPointOf(face);
    viewport_.setCameraView(viewOnto(worst, std::sqrt(face.area), viewport_.cameraView(), QSizeF(viewport_.size())));
    emit marked(MeasureMark{{{worst.place}}, worst.place, markText(face)});
}

QString FacePresenter::markText(const FaceQuality& face) const {
    if (face.gouge.amount > 0.0)
        return tr("Face %1: %2 too deep").arg(QString::number(face.number), lengthText(face.gouge.amount, unit()));
    if (face.excess.amount > 0.0)
        return tr("Face %1: %2 left").arg(QString::number(face.number), lengthText(face.excess.amount, unit()));
    return tr("Face %1").arg(face.number);
}

} // namespace burin
