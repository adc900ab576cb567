// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/project_thread.h"

#include <QCoreApplication>
#include <QSemaphore>

#include <atomic>
#include <utility>

namespace burin {

void SharedStep::add(std::shared_ptr<const ProjectStep> step) const {
    if (step) rows_->push_back(std::move(step));
}

void SharedStep::join(const SharedStep& later) const {
    rows_->insert(rows_->end(), later.rows_->begin(), later.rows_->end());
}

Result<void> SharedStep::turn(Project& project) const {
    const Rows rows = std::exchange(*rows_, {});
    for (auto step = rows.rbegin(); step != rows.rend(); ++step) {
        Result<std::shared_ptr<const ProjectStep>> turned = project.revert(**step);
        if (!turned) return std::move(turned).error();
        if (*turned) rows_->push_back(std::move(*turned));
    }
    return {};
}

ProjectThread::ProjectThread(QObject* parent) : QObject(parent), worker_(new QObject) {
    worker_->moveToThread(&thread_);
    thread_.setObjectName(QStringLiteral("project"));
    thread_.start();
}

ProjectThread::~ProjectThread() {
    enqueueJob([](std::optional<Project>& place) { place.reset(); });
    finish();
    thread_.quit();
    thread_.wait();
    delete worker_; // safe: its thread has ended
}

void ProjectThread::enqueueJob(Job job) {
    QMetaObject::invokeMethod(
        worker_, [this, job = std::move(job)] { job(place_); }, Qt::QueuedConnection);
}

void ProjectThread::follow(const SharedStep& step, const std::function<void()>& change) {
    enqueueJob([this, step](std::optional<Project>& place) {
        restoring_ = place && !step.empty();
        if (place && !restoring_) static_cast<void>(place->beginStep()); // if that fails, changes are stored each time
    });
    change();
    enqueueJob([this, step](std::optional<Project>& place) {
        if (!place) return;
        const Result<void> outcome = guarded("project", [&]() -> Result<void> {
            if (std::exchange(restoring_, false)) return step.turn(*place);
            Result<std::shared_ptr<const ProjectStep>> rows = place->endStep();
            step.add(rows ? std::move(*rows) : nullptr);
            return {};
        });
        QMetaObject::invokeMethod(
            this,
            [this, outcome] {
                if (!outcome) emit failed(outcome.error());
                emit worked();
            },
            Qt::QueuedConnection);
    });
}

void ProjectThread::join(const SharedStep& earlier, const SharedStep& later) {
    enqueueJob([earlier, later](std::optional<Project>&) { earlier.join(later); });
}

void ProjectThread::lend(std::function<void(Project*)> use) {
    enqueueJob([this, use = std::move(use)](std::optional<Project>& place) {
        QSemaphore returned;
        const auto onceHere = [&] {
            use(place ? &*place : nullptr);
            returned.release();
            emit worked();
        };
        QMetaObject::invokeMethod(this, onceHere, Qt::QueuedConnection);
        returned.acquire();
    });
}

void ProjectThread::finish() {
    auto through = std::make_shared<std::atomic<bool>>(false);
    enqueueJob([this, through](std::optional<Project>&) {
        QMetaObject::invokeMethod(
            this, [through] { *through = true; }, Qt::QueuedConnection);
    });
    // Lending and results are posted as events to this object.
    while (!*through) {
        QCoreApplication::sendPostedEvents(this, QEvent::MetaCall);
        QThread::msleep(1);
    }
}

} // namespace burin
