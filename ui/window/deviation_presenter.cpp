// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/deviation_presenter.h"

#include "core/base/background.h"
#include "ui/window/deviation_tolerance.h"

#include <QCoreApplication>
#include <QPointer>
#include <QThreadPool>

#include <utility>

namespace burin {

namespace {

constexpr double reachInVoxels = 3.0; // samples are about a voxel apart

} // namespace

DeviationPresenter::DeviationPresenter(Workbench& workbench, Viewport& viewport, DeviationCard& card,
                                       ScenePresenter& scene, QObject* parent)
    : Presenter(workbench, {&workbench.program, &workbench.mill, &workbench.workpiece}, parent)
    , viewport_(viewport)
    , card_(card)
    , scene_(scene) {
    connect(&card, &DeviationCard::switched, this, [this](bool on) {
        on_ = on;
        present();
    });
}

void DeviationPresenter::setShown(bool shown) {
    shown_ = shown;
    present();
}

void DeviationPresenter::setUnit(LengthUnit unit) {
    card_.setUnit(unit);
    Presenter::setUnit(unit);
}

void DeviationPresenter::present() {
    const bool otherScale = take(workbench_.program.upToDate());
    const bool other = std::exchange(otherMap_, false) || otherScale;
    const bool drawn = shown_ && on_ && mapped_ && !workbench_.mill.active();
    if (drawn && (other || !drawn_))
        viewport_.setDeviations({{mapped_->program, &mapped_->program->report.deviations}, tolerance_, voxel()});
    else if (!drawn && drawn_)
        viewport_.setDeviations({});
    drawn_ = drawn;
    scene_.showBarePart(drawn);
}

DeviationPresenter::Mapped::Mapped(std::shared_ptr<const CheckedProgram> of, double cell)
    : program(std::move(of)), map(program->report.deviations, cell) {}

bool DeviationPresenter::take(std::shared_ptr<const CheckedProgram> program) {
    if (program != program_) {
        program_ = std::move(program);
        if (program_) {
            makeMap();
        } else {
            mapped_.reset();
            card_.showUnderPointer({});
        }
    }
    const DeviationTolerance tolerance = deviationTolerance(workbench_);
    if (tolerance == tolerance_) return false;
    tolerance_ = tolerance;
    if (mapped_) card_.setShares(mapped_->map.shares(tolerance_), tolerance_);
    return true;
}

/// Takes more than a tenth of a second, so it runs on a thread of the pool. The previous map is kept until then.
void DeviationPresenter::makeMap() {
    const QPointer<DeviationPresenter> self(this);
    QThreadPool::globalInstance()->start([self, program = program_, cell = voxel()]() mutable {
        workInBackground();
        auto made = std::make_shared<const Mapped>(std::move(program), cell);
        QMetaObject::invokeMethod(
            QCoreApplication::instance(),
            [self, made] {
                if (self && self->program_ == made->program) self->adopt(made);
            },
            Qt::QueuedConnection);
    });
}

void DeviationPresenter::adopt(std::shared_ptr<const Mapped> made) {
    mapped_ = std::move(made);
    otherMap_ = true;
    card_.showUnderPointer({});
    card_.setShares(mapped_->map.shares(tolerance_), tolerance_);
    present();
}

double DeviationPresenter::voxel() const {
    return workbench_.workpiece.milling()->setup.voxel;
}

void DeviationPresenter::pointAt(const QPointF& position) {
    if (!drawn_) return;
    const auto place = viewport_.pick(position);
    const double reach = reachInVoxels * voxel();
    const auto sample = place ? mapped_->map.nearest(*place, reach) : std::nullopt;
    card_.showUnderPointer(sample ? std::optional(mapped_->program->report.deviations[*sample]) : std::nullopt);
}

} // namespace burin
