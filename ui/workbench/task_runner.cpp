// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/task_runner.h"

#include "core/base/background.h"
#include "ui/messages/messages.h"

#include <QLocale>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace burin {

namespace {

/// Amounts are shown as whole numbers if the total is one, otherwise with one decimal.
QString wordsOf(const ProgressStep& step) {
    if (*step.text.text == '\0') return {};
    const int decimals = step.total == std::floor(step.total) ? 0 : 1;
    const QLocale locale;
    QString words = Messages::text(step.text);
    words.replace(QLatin1String("%1"), locale.toString(step.done, 'f', decimals));
    words.replace(QLatin1String("%2"), locale.toString(step.total, 'f', decimals));
    return words;
}

} // namespace

TaskRunner::TaskRunner(QObject* parent) : QObject(parent) {
    helpInBackground();
    poll_.setInterval(std::chrono::milliseconds(50));
    connect(&poll_, &QTimer::timeout, this, &TaskRunner::changed);
}

TaskRunner::~TaskRunner() {
    waiting_.clear();
    for (const auto& task : tasks_) task->progress.cancel();
    for (const auto& task : tasks_) task->thread.join();
}

TaskRunner::Task* TaskRunner::find(TaskKind kind) const {
    const auto found = std::ranges::find_if(tasks_, [kind](const auto& task) { return task->kind == kind; });
    return found == tasks_.end() ? nullptr : found->get();
}

void TaskRunner::startTask(TaskKind kind, const QString& title, Run run) {
    auto task = std::make_unique<Task>();
    task->kind = kind;
    task->title = title;
    task->run = std::move(run);
    std::erase_if(waiting_, [kind](const auto& other) { return other->kind == kind; });
    if (Task* running = find(kind)) {
        running->superseded = true;
        running->progress.cancel();
        waiting_.push_back(std::move(task));
    } else {
        launch(std::move(task));
    }
    emit changed();
}

void TaskRunner::launch(std::unique_ptr<Task> task) {
    task->id = ++lastId_;
    Task* started = task.get();
    tasks_.push_back(std::move(task));
    started->thread = std::thread([this, started] {
        // The thread that reads a device must not have low priority.
        if (started->kind != TaskKind::device) workInBackground();
        started->delivery = started->run(started->progress);
        QMetaObject::invokeMethod(
            this, [this, id = started->id] { ended(id); }, Qt::QueuedConnection);
    });
    poll_.start();
}

void TaskRunner::ended(quint64 id) {
    const auto place = std::ranges::find_if(tasks_, [id](const auto& task) { return task->id == id; });
    const std::unique_ptr<Task> over = std::move(*place);
    tasks_.erase(place);
    over->thread.join();
    const auto next = std::ranges::find_if(waiting_, [&](const auto& task) { return task->kind == over->kind; });
    if (next != waiting_.end()) {
        std::unique_ptr<Task> follower = std::move(*next);
        waiting_.erase(next);
        launch(std::move(follower));
    }
    if (tasks_.empty()) poll_.stop();
    if (!over->superseded) over->delivery();
    runIdleWork();
    emit changed();
}

void TaskRunner::whenIdle(std::function<void()> then) {
    idleWork_.push_back(std::move(then));
    runIdleWork();
}

void TaskRunner::runIdleWork() {
    while (idle() && !idleWork_.empty()) {
        const std::function<void()> work = std::move(idleWork_.front());
        idleWork_.erase(idleWork_.begin());
        work();
    }
}

void TaskRunner::rename(TaskKind kind, const QString& title) {
    Task* task = find(kind);
    if (task == nullptr) return;
    task->title = title;
    emit changed();
}

void TaskRunner::cancel(TaskKind kind) {
    cancelThose([kind](const Task& task) { return task.kind == kind; });
}

void TaskRunner::cancelAll() {
    cancelThose([](const Task&) { return true; });
}

/// Including waiting tasks, whose callers are notified when it is their turn.
template <class Which>
void TaskRunner::cancelThose(Which which) {
    for (const auto* list : {&tasks_, &waiting_})
        for (const auto& task : *list)
            if (which(*task)) task->progress.cancel();
    emit changed();
}

void TaskRunner::abandon(TaskKind kind) {
    std::erase_if(waiting_, [kind](const auto& other) { return other->kind == kind; });
    if (Task* task = find(kind)) task->superseded = true;
    cancel(kind);
}

bool TaskRunner::running(TaskKind kind) const {
    const auto isRequested = [kind](const auto& task) { return task->kind == kind && !task->superseded; };
    return std::ranges::any_of(tasks_, isRequested) || std::ranges::any_of(waiting_, isRequested);
}

double TaskRunner::fraction(TaskKind kind) const {
    const Task* task = find(kind);
    return task == nullptr ? 0.0 : task->progress.fraction();
}

std::vector<TaskRow> TaskRunner::rows() const {
    std::vector<TaskRow> rows;
    for (const auto& task : tasks_)
        rows.push_back({task->kind, task->title, wordsOf(task->progress.step()), task->progress.fraction(),
                        task->progress.cancelled()});
    // Tasks that nobody waits for are listed last.
    std::ranges::stable_partition(rows, [](const TaskRow& row) { return row.kind != TaskKind::growth; });
    return rows;
}

} // namespace burin
