// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/take_deviations.h"

#include <utility>

namespace burin {

TakeDeviations::TakeDeviations(const Desk& desk, const WorkpieceController& workpiece, const SessionRunner& session,
                               TimeController& time, QObject* parent)
    : Controller(desk, parent), workpiece_(workpiece), session_(session), time_(time) {
    connect(&time_, &TimeController::recordedChanged, this, &TakeDeviations::goOn);
    connect(&session_, &SessionRunner::changed, this, &TakeDeviations::goOn);
    connect(&workpiece_, &WorkpieceController::readersStop, this, &TakeDeviations::stop);
    connect(&workpiece_, &WorkpieceController::readersGoOn, this, &TakeDeviations::goOn);
}

void TakeDeviations::setRequested(bool wanted) {
    if (std::exchange(wanted_, wanted) == wanted) return;
    stopped_ = false;
    failed_.clear();
    wanted_ ? goOn() : stop();
}

void TakeDeviations::forget() {
    stop();
    stopped_ = false;
    failed_.clear();
}

void TakeDeviations::stop() {
    if (!busy()) return;
    if (const auto reading = std::exchange(reading_, nullptr)) reading->cancel();
    desk_.tasks.abandon(TaskKind::deviation);
    emit changed();
}

/// The first take whose deviation is not known.
std::optional<TakeInfo> TakeDeviations::next() const {
    if (!time_.recordings()) return std::nullopt;
    for (const TakeTrack& track : time_.recordings()->tracks)
        if (track.curves[static_cast<std::size_t>(TrackCurve::deviation)].empty() && track.info.sampleCount > 0 &&
            !failed_.contains(track.info.id))
            return track.info;
    return std::nullopt;
}

void TakeDeviations::goOn() {
    if (session_.running()) return stop(); // the processors belong to milling; it goes on afterwards
    if (!wanted_ || stopped_ || busy() || !workpiece_.milling() || workpiece_.changing()) return;
    const std::optional<TakeInfo> take = next();
    if (!take) return;
    const auto reading = reading_ = std::make_shared<Progress>();
    desk_.project.ask(
        [id = take->id, reading](const Project& project) { return deviationMatter(project, id, *reading); },
        [this, reading, id = take->id](Result<DeviationMatter> matter) {
            if (reading != reading_) return;
            reading_.reset();
            if (matter && workpiece_.milling()) return compute(std::move(*matter));
            if (!matter) refuse(id, matter.error());
        });
    emit changed();
}

void TakeDeviations::compute(DeviationMatter matter) {
    const TakeInfo info = matter.info;
    desk_.tasks.start(
        TaskKind::deviation, tr("Computing the deviation of the takes"),
        [milling = workpiece_.milling(), matter = std::move(matter)](Progress& progress) {
            return takeDeviation(matter, milling->part, progress);
        },
        [this, info](Result<std::vector<float>> values) {
            if (!values) return refuse(info.id, values.error());
            time_.addDeviation(info.id, info.sampleCount, std::move(*values));
            goOn(); // if that take has changed since
            emit changed();
        });
}

void TakeDeviations::refuse(std::int64_t take, const Error& error) {
    if (error.code == ErrorCode::cancelled) {
        stopped_ = true;
    } else {
        failed_.insert(take);
        emit failed(error);
        goOn();
    }
    emit changed();
}

} // namespace burin
