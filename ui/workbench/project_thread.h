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
#include <vector>

namespace burin {

/// What an entry of the undo stack changed in the rows of the project, in the order in which it did; empty: nothing
/// that is known. The rows belong to the project's thread alone, the object itself to any.
class SharedStep {
public:
    SharedStep() : rows_(std::make_shared<Rows>()) {}

    // Project's thread:
    bool empty() const noexcept { return rows_->empty(); }
    void add(std::shared_ptr<const ProjectStep> step) const;
    /// Adds the rows of a later entry that is merged into this one.
    void join(const SharedStep& later) const;
    /// Makes the rows what they were on the other side of the entry, and turns the step around. Errors: those of
    /// Project::revert. The rows are not known then.
    Result<void> turn(Project& project) const;

private:
    using Rows = std::vector<std::shared_ptr<const ProjectStep>>;
    std::shared_ptr<Rows> rows_;
};

/// Holds the open project on a thread of its own, so that the user interface never waits for the disk. Work is done in
/// the order in which it was posted. The one exception is `lend`: a session must start and stop within some
/// milliseconds, so the project is lent to the user interface's thread while its own thread is blocked; it thus always
/// belongs to one thread. All functions: user interface's thread.
class ProjectThread : public QObject {
    Q_OBJECT
public:
    explicit ProjectThread(QObject* parent = nullptr);
    ~ProjectThread() override; ///< completes the posted work, then closes the project

    /// Runs `work` on the project's thread; its argument is the optional that holds the project (empty if none is open)
    /// and it returns a Result<T>. `done` gets that result on the user interface's thread.
    template <class Work, class Done>
    void postToPlace(Work work, Done done) {
        using Outcome = std::invoke_result_t<Work&, std::optional<Project>&>;
        enqueue([this, work = std::move(work), done = std::move(done)](std::optional<Project>& place) mutable {
            auto outcome = std::make_shared<Outcome>(guarded("project", [&]() -> Outcome { return work(place); }));
            QMetaObject::invokeMethod(
                this, [outcome, done = std::move(done)]() mutable { done(std::move(*outcome)); }, Qt::QueuedConnection);
        });
    }
    /// The same for work on a project. If none is open, the error is internalFault.
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
    /// `ask` for work that may change the project: `worked` is emitted afterwards.
    template <class Work, class Done>
    void post(Work work, Done done) {
        using Outcome = std::invoke_result_t<Work&, Project&>;
        ask(std::move(work), [this, done = std::move(done)](Outcome outcome) mutable {
            done(std::move(outcome));
            emit worked();
        });
    }
    /// `post` for work that is an entry of the undo stack; if it fails, what it stored is reverted. @param done gets
    /// the result and the step
    template <class Work, class Done>
    void postStep(Work work, Done done) {
        using Outcome = std::invoke_result_t<Work&, Project&>;
        const SharedStep step;
        post(
            [work = std::move(work), step](Project& project) mutable -> Outcome {
                if (Result<void> begun = project.beginStep(); !begun) return std::move(begun).error();
                Outcome outcome = work(project);
                Result<std::shared_ptr<const ProjectStep>> rows = project.endStep();
                if (!rows) return std::move(rows).error();
                if (outcome)
                    step.add(std::move(*rows));
                else if (*rows) // it has not succeeded as a whole
                    static_cast<void>(project.revert(**rows));
                return outcome;
            },
            [step, done = std::move(done)](Outcome outcome) mutable { done(std::move(outcome), step); });
    }
    /// Calls `change`, which may change the project through Controller::store. If the rows of `step` are not known,
    /// they are recorded. Otherwise they are made what they were on the other side of it instead of being stored again.
    void follow(const SharedStep& step, const std::function<void()>& change);
    /// Joins the step of an entry that was merged into an earlier one.
    void join(const SharedStep& earlier, const SharedStep& later);
    /// Whether what is to be stored is restored by `follow` anyway. Project's thread.
    bool restoring() const noexcept { return restoring_; }
    /// Calls `use` on the user interface's thread once the work posted before is done, while the project's thread is
    /// blocked. Null if no project is open.
    void lend(std::function<void(Project*)> use);

    /// Waits until all posted work is done and its results are delivered. Only for the end of the program.
    void finish();

signals:
    void worked();                          ///< the project may have changed
    void failed(const burin::Error& error); ///< of `follow`, or a change that History refuses

private:
    using Job = std::function<void(std::optional<Project>&)>;
    template <class Work>
    void enqueue(Work work) {
        auto shared = std::make_shared<Work>(std::move(work)); // std::function requires a copyable object
        enqueueJob([shared](std::optional<Project>& place) { (*shared)(place); });
    }
    void enqueueJob(Job job);

    QThread thread_;
    QObject* worker_ = nullptr;    ///< lives in thread_
    bool restoring_ = false;       ///< thread_ alone
    std::optional<Project> place_; ///< accessed by thread_ alone, except while it is lent
};

} // namespace burin
