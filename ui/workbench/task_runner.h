// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/guarded.h"
#include "core/base/progress.h"

#include <QObject>
#include <QString>
#include <QTimer>

#include <functional>
#include <memory>
#include <thread>
#include <type_traits>
#include <vector>

namespace burin {

/// Long tasks of the window; of each kind one runs at a time.
enum class TaskKind {
    importing,
    embedding,
    field,
    growth,
    planning,
    edges,
    fixture,
    path,
    pass,
    previewBasis,
    preview,
    measuring,
    pathValues,
    comparison,
    measure,
    program,
    device,
    drivers,
    deviceTest,
    axes,
    viewDevice,
    exporting,
    stock,
    tool,
    placing,
    face,
    furtherSetup,
    sheet,
    time,
    programTime,
    keeping,
    punchingIn,
    faces,
    score,
    deviation,
    outdated,
    stockSolid,
    fixtureFit,
    fixturePlacing,
    fixtureJudging,
    touching
};

/// A task as the status line shows it.
struct TaskRow {
    TaskKind kind = TaskKind::importing;
    QString title;
    QString step;          ///< what the task is doing; empty: it does not say
    double fraction = 0.0; ///< 0 … 1
    bool cancelling = false;
};

/// Runs long work on worker threads, with progress and cancellation, at a lower priority than drawing and the haptic
/// loop. Starting a task while another of its kind is running replaces it: the old one is cancelled and its result
/// discarded. User interface's thread.
class TaskRunner : public QObject {
    Q_OBJECT
public:
    explicit TaskRunner(QObject* parent = nullptr);
    ~TaskRunner() override; ///< cancels everything and waits for it; no more results are delivered

    /// @param work Result<T>(Progress&), on a worker. @param done gets its result on this object's thread.
    template <class Work, class Done>
    void start(TaskKind kind, const QString& title, Work work, Done done) {
        using Outcome = std::invoke_result_t<Work&, Progress&>;
        struct Parts {
            Work work;
            Done done;
        };
        auto parts = std::make_shared<Parts>(Parts{std::move(work), std::move(done)});
        startTask(kind, title, [parts](Progress& progress) -> Delivery {
            auto outcome = std::make_shared<Outcome>(guarded("background work", [&]() -> Outcome {
                if (progress.cancelled()) return Error{ErrorCode::cancelled, "background work", {}, {}};
                return parts->work(progress);
            }));
            return [parts, outcome] { parts->done(std::move(*outcome)); };
        });
    }
    /// Gives the running task of a kind another title, for another phase of it.
    void rename(TaskKind kind, const QString& title);
    /// Requests the task of a kind to stop; its result is then ErrorCode::cancelled, unless it was complete before.
    /// Applies also to one that waits for another to end.
    void cancel(TaskKind kind);
    void cancelAll();
    /// Cancels the task of a kind and discards its result.
    void abandon(TaskKind kind);
    /// Calls `then` once no task is running or waiting, when data that tasks read may be changed. At once if there are
    /// none.
    void whenIdle(std::function<void()> then);
    bool running(TaskKind kind) const;    ///< or waiting; an abandoned task does not count, although it has yet to end
    double fraction(TaskKind kind) const; ///< progress of the running task of a kind, 0 … 1; 0 if none is running
    bool idle() const { return tasks_.empty() && waiting_.empty(); }
    std::vector<TaskRow> rows() const;

signals:
    /// A task started, advanced or ended; about 20 times a second while one is running.
    void changed();

private:
    using Delivery = std::function<void()>;
    using Run = std::function<Delivery(Progress&)>;
    struct Task {
        quint64 id = 0;
        TaskKind kind = TaskKind::importing;
        QString title;
        Run run;
        Progress progress;
        Delivery delivery; ///< written by the worker before it ends
        bool superseded = false;
        std::thread thread;
    };
    void startTask(TaskKind kind, const QString& title, Run run);
    void launch(std::unique_ptr<Task> task);
    void ended(quint64 id);
    void runIdleWork();
    Task* find(TaskKind kind) const;
    template <class Which>
    void cancelThose(Which which);

    std::vector<std::unique_ptr<Task>> tasks_;   ///< running
    std::vector<std::unique_ptr<Task>> waiting_; ///< for one of their kind to end
    std::vector<std::function<void()>> idleWork_;
    quint64 lastId_ = 0;
    QTimer poll_;
};

} // namespace burin
