// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/project_thread.h"

#include <QCoreApplication>
#include <QSemaphore>

#include <atomic>

namespace burin {

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
