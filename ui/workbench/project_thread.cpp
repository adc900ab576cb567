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
    Rows turned;
    for (auto step = rows.rbegin(); step != rows.rend(); ++step) {
        Result<std::shared_ptr<const ProjectStep>> other = project.revert(**step);
        if (!other) { // no part of the entry may stay turned
            for (auto done = turned.rbegin(); done != turned.rend(); ++done)
                static_cast<void>(project.revert(**done)); // a failure is covered by the same error
            return std::move(other).error();
        }
        if (*other) turned.push_back(std::move(*other));
    }
    *rows_ = std::move(turned);
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

/// The rows are restored first, as `change` may also ask for what the project holds then.
void ProjectThread::follow(const SharedStep& step, const std::function<void()>& change) {
    enqueueJob([this, step](std::optional<Project>& place) {
        if (!place) return;
        const bool known = !step.empty();
        const Result<void> turned =
            guarded("project", [&]() -> Result<void> { return known ? step.turn(*place) : Result<void>(); });
        restoring_ = known && turned;                           // otherwise everything is stored again
        if (!restoring_) static_cast<void>(place->beginStep()); // if that fails, changes are stored each time
        if (turned) return;
        QMetaObject::invokeMethod(
            this, [this, error = turned.error()] { emit failed(error); }, Qt::QueuedConnection);
    });
    change();
    enqueueJob([this, step](std::optional<Project>& place) {
        if (place && !std::exchange(restoring_, false))
            if (auto rows = guarded("project", [&] { return place->endStep(); }); rows) step.add(std::move(*rows));
        QMetaObject::invokeMethod(
            this, [this] { emit worked(); }, Qt::QueuedConnection);
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
