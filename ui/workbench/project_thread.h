// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/guarded.h"
#include "core/document/project.h"

#include <QObject>
#include <QThread>

#include <functional>
#include <memory>
#include <optional>
#include <type_traits>

namespace burin {

/// The open project on a thread of its own: the user interface never waits for the disk. Work is done in the order in
/// which it was posted. The one exception is `lend`: for a session's start and stop, whose contract is some
/// milliseconds, the project comes to the user interface's thread while its own stands still, so that it always belongs
/// to one thread. All functions: user interface's thread.
class ProjectThread : public QObject {
    Q_OBJECT
public:
    explicit ProjectThread(QObject* parent = nullptr);
    ~ProjectThread() override; ///< does what was posted, then closes the project

    /// Runs `work`, a function of the place where the project is (empty: none is open) that gives a Result<T>, on the
    /// project's thread; `done` gets what it gave on the user interface's.
    template <class Work, class Done>
    void postToPlace(Work work, Done done) {
        using Outcome = std::invoke_result_t<Work&, std::optional<Project>&>;
        enqueue([this, work = std::move(work), done = std::move(done)](std::optional<Project>& place) mutable {
            auto outcome = std::make_shared<Outcome>(guarded("project", [&]() -> Outcome { return work(place); }));
            QMetaObject::invokeMethod(
                this, [outcome, done = std::move(done)]() mutable { done(std::move(*outcome)); }, Qt::QueuedConnection);
        });
    }
    /// The same for work on a project. Where none is open, the error is internalFault.
    template <class Work, class Done>
    void ask(Work work, Done done) {
        using Outcome = std::invoke_result_t<Work&, Project&>;
        postToPlace(
            [work = std::move(work)](std::optional<Project>& place) mutable -> Outcome {
                if (!place) return Error{ErrorCode::internalFault, "project", {}, "none is open"};
                return work(*place);
            },
            std::move(done));
    }
    /// `ask` for work that may change the project: `worked` follows.
    template <class Work, class Done>
    void post(Work work, Done done) {
        using Outcome = std::invoke_result_t<Work&, Project&>;
        ask(std::move(work), [this, done = std::move(done)](Outcome outcome) mutable {
            done(std::move(outcome));
            emit worked();
        });
    }
    /// Calls `use` on the user interface's thread as soon as what was posted before is done, while the project's thread
    /// stands still. Null: no project is open.
    void lend(std::function<void(Project*)> use);

    /// Waits until everything that was posted is done and its outcomes were delivered. For the program's end alone.
    void finish();

signals:
    void worked(); ///< the project may have changed

private:
    using Job = std::function<void(std::optional<Project>&)>;
    template <class Work>
    void enqueue(Work work) {
        auto shared = std::make_shared<Work>(std::move(work)); // std::function wants a copy
        enqueueJob([shared](std::optional<Project>& place) { (*shared)(place); });
    }
    void enqueueJob(Job job);

    QThread thread_;
    QObject* worker_ = nullptr;    ///< lives in thread_
    std::optional<Project> place_; ///< thread_'s alone, but while it is lent
};

} // namespace burin
