// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/coach/first_job_steps.h"

#include <QObject>

namespace burin {

/// How far the user is in the first job. A step ends when the workbench shows that it was done, whatever way the user
/// did it; where a needed one is undone, the first job goes back to it. User interface's thread.
class FirstJob final : public QObject {
    Q_OBJECT
public:
    explicit FirstJob(Workbench& workbench); ///< which outlives it

    void begin(); ///< at the first step, whatever was done before
    void end();
    bool running() const noexcept { return running_; }
    std::size_t at() const noexcept { return at_; } ///< place in `firstJobSteps`; their number: all are behind
    bool finished() const { return at_ == firstJobSteps().size(); }
    bool isDone() const; ///< the present step, which the user went back to
    void back();
    void skip(); ///< the present step, or goes on from one that was done before

signals:
    void stepChanged();
    void lookedAt(); ///< something in the workbench has changed

private:
    enum class Mark { open, done, skipped };
    void look();
    bool done(std::size_t step) const;
    void goTo(std::size_t step);

    Workbench& workbench_;
    FirstJobFacts facts_;
    std::vector<Mark> marks_;
    std::size_t at_ = 0;
    bool running_ = false;
    bool revisited_ = false; ///< the user went back to the present step, which was done: it does not end by that
};

} // namespace burin
