// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/window/deviation_presenter.h"

#include <algorithm>

namespace burin {

namespace {

constexpr double reachInVoxels = 3.0; // samples are about a voxel apart

DeviationTolerance toleranceOf(const Workbench& workbench) {
    DeviationTolerance tolerance;
    tolerance.gouge = workbench.program.gougeTolerance();
    tolerance.allowance = workbench.mill.allowance();
    return tolerance;
}

} // namespace

DeviationPresenter::DeviationPresenter(Workbench& workbench, Viewport& viewport, DeviationCard& card,
                                       ScenePresenter& scene, QObject* parent)
    : Presenter(workbench, {&workbench.program, &workbench.mill, &workbench.bench}, parent)
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
    const ProgramController& program = workbench_.program;
    const bool fits = program.program() && !program.edited() && !program.outdated() && workbench_.bench.bench();
    const bool other = take(fits ? program.program() : nullptr);
    const bool drawn = shown_ && on_ && map_ && !workbench_.mill.active();
    if (drawn && (other || !drawn_))
        viewport_.setDeviations({{program_, &program_->report.deviations}, tolerance_, voxel()});
    else if (!drawn && drawn_)
        viewport_.setDeviations({});
    drawn_ = drawn;
    scene_.showBarePart(drawn);
}

bool DeviationPresenter::take(std::shared_ptr<const CheckedProgram> program) {
    const DeviationTolerance tolerance = toleranceOf(workbench_);
    if (program == program_ && tolerance == tolerance_) return false;
    tolerance_ = tolerance;
    if (program != program_) {
        map_.reset();
        program_ = std::move(program);
        if (program_) map_ = std::make_unique<DeviationMap>(program_->report.deviations, voxel());
        card_.showUnderPointer({});
    }
    if (map_) card_.setShares(map_->shares(tolerance_), tolerance_);
    return true;
}

double DeviationPresenter::voxel() const {
    return workbench_.bench.bench()->setup.voxel;
}

void DeviationPresenter::pointAt(const QPointF& position) {
    if (!drawn_) return;
    const auto place = viewport_.pick(position);
    const double reach = reachInVoxels * voxel();
    const auto sample = place ? map_->nearest(*place, reach) : std::nullopt;
    card_.showUnderPointer(sample ? std::optional(program_->report.deviations[*sample]) : std::nullopt);
}

} // namespace burin
