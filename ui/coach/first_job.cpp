// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/coach/first_job.h"

#include "ui/workbench/workbench.h"

namespace burin {

FirstJob::FirstJob(Workbench& workbench) : workbench_(workbench), facts_{workbench, {}, false} {
    for (const Controller* controller : workbench.controllers())
        connect(controller, &Controller::changed, this, &FirstJob::look);
    connect(&workbench.path, &PathController::evaluatedAnew, this, &FirstJob::look);
    connect(&workbench.session, &SessionRunner::ticked, this, &FirstJob::look);
    connect(&workbench.program, &ProgramController::exported, this, [this] {
        facts_.exported = true;
        look();
    });
}

void FirstJob::begin() {
    running_ = true;
    revisited_ = false;
    at_ = 0;
    marks_.assign(firstJobSteps().size(), Mark::open);
    facts_.firstTool = workbench_.tool.current().id;
    facts_.exported = false;
    emit stepChanged();
    look();
}

void FirstJob::end() {
    running_ = false;
}

bool FirstJob::done(std::size_t step) const {
    return firstJobSteps()[step].done(facts_);
}

bool FirstJob::isDone() const {
    return !finished() && revisited_;
}

void FirstJob::back() {
    if (!running_ || at_ == 0) return;
    goTo(at_ - 1);
}

void FirstJob::skip() {
    if (!running_ || finished()) return;
    marks_[at_] = done(at_) ? Mark::done : Mark::skipped;
    revisited_ = false;
    ++at_;
    emit stepChanged();
    look();
}

void FirstJob::goTo(std::size_t step) {
    at_ = step;
    revisited_ = done(step);
    marks_[step] = Mark::open;
    emit stepChanged();
}

void FirstJob::look() {
    if (!running_) return;
    const std::size_t before = at_;
    const std::vector<FirstJobStep>& steps = firstJobSteps();
    for (std::size_t i = 0; i < at_; ++i)
        if (steps[i].needed && marks_[i] == Mark::done && !done(i)) {
            at_ = i;
            marks_[i] = Mark::open;
            revisited_ = false;
        }
    if (revisited_ && !done(at_)) revisited_ = false;
    if (!revisited_)
        for (; at_ < steps.size() && (marks_[at_] == Mark::skipped || done(at_)); ++at_)
            if (marks_[at_] == Mark::open) marks_[at_] = Mark::done;
    if (at_ != before) emit stepChanged();
    emit lookedAt();
}

} // namespace burin
