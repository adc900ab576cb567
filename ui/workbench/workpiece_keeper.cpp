// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/workpiece_keeper.h"

#include "core/job/recorded_cuts.h"
#include "core/volume/operations/fingerprint.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace burin {

namespace {

constexpr std::chrono::milliseconds rest(500); // without a change of recordings

} // namespace

WorkpieceKeeper::WorkpieceKeeper(const Desk& desk, WorkpieceController& workpiece, SessionRunner& session,
                                 MillController& mill, QObject* parent)
    : Controller(desk, parent), workpiece_(workpiece), session_(session), mill_(mill) {
    rest_.setSingleShot(true);
    rest_.setInterval(rest);
    connect(&rest_, &QTimer::timeout, this, &WorkpieceKeeper::keep);
    connect(&workpiece_, &WorkpieceController::replayed, this, &WorkpieceKeeper::wait);
    connect(&workpiece_, &WorkpieceController::workpieceChanged, this, &WorkpieceKeeper::wait);
    connect(&mill_, &MillController::takesChanged, this, &WorkpieceKeeper::wait);
    connect(&mill_, &MillController::recordingBegan, this, &WorkpieceKeeper::wait);
    connect(&session_, &SessionRunner::ended, this, &WorkpieceKeeper::wait);
}

void WorkpieceKeeper::forget() {
    wait();
    rest_.stop();
}

/// The workpiece is changing.
void WorkpieceKeeper::wait() {
    ++generation_;
    desk_.tasks.abandon(TaskKind::keeping);
    rest_.start();
    if (std::exchange(hash_, std::nullopt)) emit changed();
}

/// During a session the workpiece must not be read; the end of the session starts the timer again.
void WorkpieceKeeper::keep() {
    if (session_.running() || !workpiece_.embedded() || workpiece_.embedding()) return;
    const std::vector<TakeInfo>& takes = mill_.allTakes();
    const bool whole = !takes.empty() && std::ranges::all_of(takes, &TakeInfo::complete);
    const TakeMoment end = takes.empty() ? TakeMoment{} : TakeMoment{takes.back().id, takes.back().sampleCount};
    std::map<std::int64_t, std::size_t> strokes;
    for (const TakeInfo& take : takes) strokes[take.id] = mill_.strokesOf(take.id);
    desk_.project.ask(
        [end, whole](Project& project) -> Result<Requested> {
            const Result<std::vector<TakeMoment>> kept = project.keptMoments();
            if (!kept) return kept.error();
            const Result<RecordedState> state = project.recordedState();
            if (!state) return state.error();
            return Requested{*state, whole && !project.readOnly() && state->end == end &&
                                         std::ranges::find(*kept, end) == kept->end()};
        },
        [this, generation = generation_, strokes = std::move(strokes),
         snapshot = workpiece_.milling()->embedded.workpiece.snapshot()](const Result<Requested>& wanted) {
            // Earlier changes of the project have been signalled here by now: they changed the generation, or make the
            // workpiece be recomputed.
            if (wanted && generation == generation_ && !workpiece_.embedding() && !session_.running())
                look(*wanted, strokes, snapshot);
        });
}

void WorkpieceKeeper::look(const Requested& wanted, std::map<std::int64_t, std::size_t> strokes,
                           VolumeSnapshot workpiece) {
    struct Seen {
        std::uint64_t hash = 0;
        std::optional<KeptWorkpiece> kept;
    };
    desk_.tasks.start(
        TaskKind::keeping, tr("Storing the workpiece"),
        [wanted, strokes = std::move(strokes), workpiece = std::move(workpiece)](Progress& progress) -> Result<Seen> {
            Seen seen{fingerprint(workpiece), std::nullopt};
            if (!wanted.keeps) return seen;
            Result<KeptWorkpiece> kept = keptAs(workpiece, wanted.state.end, strokes, progress);
            if (!kept) return std::move(kept).error();
            seen.kept = std::move(*kept);
            return seen;
        },
        [this, state = wanted.state](Result<Seen> seen) {
            if (!seen) return;
            hash_ = seen->hash;
            if (seen->kept) store(state, std::move(*seen->kept));
            emit changed();
        });
}

/// The project compares the state to detect changes made meanwhile.
void WorkpieceKeeper::store(const RecordedState& state, KeptWorkpiece kept) {
    desk_.project.ask([state, kept = std::move(kept)](Project& project) { return project.keepWorkpiece(kept, state); },
                      [](const Result<void>&) {});
}

} // namespace burin
