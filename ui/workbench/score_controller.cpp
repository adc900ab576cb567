// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/score_controller.h"

#include "core/job/job_paths.h"

#include <algorithm>
#include <utility>

namespace burin {

ScoreController::ScoreController(const Desk& desk, const WorkpieceController& workpiece, const SessionRunner& session,
                                 MillController& mill, QObject* parent)
    : Controller(desk, parent), workpiece_(workpiece), session_(session), mill_(mill) {
    connect(&mill, &MillController::takesChanged, this, &ScoreController::followTakes);
}

bool ScoreController::possible() const {
    return workpiece_.milling() && !workpiece_.embedding() && !session_.running() && !mill_.allTakes().empty();
}

void ScoreController::choose(std::int64_t take, std::int64_t reference) {
    cancel();
    take_ = take;
    reference_ = reference == take ? 0 : reference;
    scores_.clear();
    if (!possible()) return emit changed();
    const auto reading = reading_ = std::make_shared<Progress>();
    desk_.project.ask([take, other = reference_ == 0 ? std::nullopt : std::optional(reference_),
                       reading](const Project& project) { return scoreMatters(project, take, other, *reading); },
                      [this, reading](Result<std::vector<ScoreMatter>> matters) {
                          if (reading != reading_) return;
                          reading_.reset();
                          if (matters && workpiece_.milling()) return run(std::move(*matters));
                          if (!matters) emit failed(matters.error());
                          emit changed();
                      });
    emit changed();
}

void ScoreController::ask(std::int64_t take) {
    if (!possible()) return;
    const std::vector<TakeInfo>& takes = mill_.allTakes();
    if (take == 0) take = newestTake(takes).id;
    const auto other = std::ranges::find_if(takes, [take](const TakeInfo& info) { return info.id != take; });
    const std::int64_t first = other == takes.end() ? 0 : other->id;
    choose(take, reference_ != 0 && reference_ != take ? reference_ : first);
    emit asked();
}

void ScoreController::run(std::vector<ScoreMatter> matters) {
    desk_.tasks.start(
        TaskKind::score, tr("Scoring"),
        [milling = workpiece_.milling(), matters = std::move(matters)](Progress& progress) mutable {
            return takeScores(std::move(matters), *milling, progress);
        },
        [this](Result<std::vector<TakeScore>> scores) {
            if (scores)
                scores_ = std::move(*scores);
            else if (scores.error().code != ErrorCode::cancelled)
                emit failed(scores.error());
            emit changed();
        });
    emit changed();
}

void ScoreController::cancel() {
    if (!busy()) return;
    if (const auto reading = std::exchange(reading_, nullptr)) reading->cancel();
    desk_.tasks.abandon(TaskKind::score);
    emit changed();
}

void ScoreController::setDrawn(bool drawn) {
    if (std::exchange(drawn_, drawn) != drawn) emit changed();
}

/// The scored recordings may have changed or been removed: those that still exist are scored again.
void ScoreController::followTakes() {
    const bool wanted = busy() || !scores_.empty();
    cancel();
    scores_.clear();
    const auto gone = [this](std::int64_t take) {
        return std::ranges::find(mill_.allTakes(), take, &TakeInfo::id) == mill_.allTakes().end();
    };
    if (gone(take_)) take_ = 0;
    if (gone(reference_)) reference_ = 0;
    if (wanted && take_ != 0) return choose(take_, reference_);
    emit changed();
}

void ScoreController::discard() {
    cancel();
    scores_.clear();
    emit changed();
}

void ScoreController::forget() {
    take_ = reference_ = 0;
    discard();
}

} // namespace burin
