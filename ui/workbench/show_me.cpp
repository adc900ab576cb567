// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/show_me.h"

#include "core/haptics/operator/virtual_operator.h"

namespace burin {

namespace {

/// The paper's model wax allows deep, wide cuts; the fine finishing passes remove the remaining steps.
OperatorRequest requestFor(const Tool& tool) {
    OperatorRequest request;
    const double diameter = tool.cutter.diameter;
    request.levelDepth = 1.4 * diameter;
    request.finishingDepth = 2.0 * diameter;
    request.roughingStepOver = 0.85 * diameter;
    request.finishingStepOver = diameter / 8.0;
    return request;
}

} // namespace

ShowMe::ShowMe(const Desk& desk, WorkpieceController& workpiece, SessionRunner& session, QObject* parent)
    : Controller(desk, parent), workpiece_(workpiece), session_(session) {
    connect(&session_, &SessionRunner::endedByItself, this, [this] {
        if (showing()) session_.end();
    });
    connect(&session_, &SessionRunner::ended, this, &ShowMe::sessionEnded);
}

void ShowMe::start() {
    if (showing() || session_.running() || !workpiece_.ready()) return;
    stage_ = Stage::planning;
    stopped_ = false;
    desk_.tasks.start(
        TaskKind::planning, tr("Planning the strokes"),
        [workpiece = workpiece_.milling(), bounds = workpiece_.bounds(),
         request = requestFor(workpiece_.milling()->tool)](Progress& progress) -> Result<OperatorPlan> {
            if (Result<void> whole = bounds->finish(progress); !whole) return std::move(whole).error();
            return planOperator(*workpiece, *bounds, request);
        },
        [this](Result<OperatorPlan> plan) {
            if (!plan) {
                emit failed(plan.error());
                endShow(false);
                return;
            }
            if (stopped_) {
                endShow(false);
                return;
            }
            plan_ = std::move(*plan);
            next_ = 0;
            millNext();
        });
    emit changed();
}

void ShowMe::stop() {
    if (!showing()) return;
    stopped_ = true;
    if (stage_ == Stage::planning)
        desk_.tasks.cancel(TaskKind::planning);
    else
        session_.end();
}

void ShowMe::millNext() {
    if (next_ >= plan_.stages.size()) {
        endShow(true);
        return;
    }
    stage_ = Stage::milling;
    const OperatorStage& wanted = plan_.stages[next_++];
    SessionRequest request;
    request.mapping = plan_.mapping;
    request.felt = plan_.felt;
    request.ticksPerEdge = timeLapse;
    request.allowance = wanted.allowance;
    request.takeName = wanted.name;
    auto stylus = std::make_unique<VirtualOperator>(wanted.intent, plan_.mapping, plan_.hand);
    session_.begin({workpiece_.milling(), workpiece_.bounds(), &workpiece_.strokes()}, std::move(stylus), request,
                   [this](bool begun) {
                       if (!begun) endShow(false);
                   });
    emit changed();
}

void ShowMe::sessionEnded() {
    if (stage_ != Stage::milling) return;
    if (stopped_)
        endShow(false);
    else
        millNext();
}

void ShowMe::endShow(bool whole) {
    stage_ = Stage::none;
    plan_ = {};
    emit changed();
    emit finished(whole);
}

} // namespace burin
