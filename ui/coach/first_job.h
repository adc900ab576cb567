// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/coach/first_job_steps.h"

#include <QObject>

namespace burin {

/// The user's progress in the first job. A step ends when the state of the workbench shows that it was done, no matter
/// how the user did it; if a required step is undone, the first job returns to it. Used on the GUI thread.
class FirstJob final : public QObject {
    Q_OBJECT
public:
    explicit FirstJob(Workbench& workbench); ///< must outlive this object

    void begin(); ///< starts at the first step, whatever was done before
    void end();
    bool running() const noexcept { return running_; }
    std::size_t at() const noexcept { return at_; } ///< index in `firstJobSteps`; their number once all are passed
    bool finished() const { return at_ == firstJobSteps().size(); }
    bool isDone() const; ///< whether the user went back to the present step and it is done
    void back();
    void skip(); ///< skips the present step, or continues from one that was done before

signals:
    void stepChanged();
    void lookedAt(); ///< the workbench was examined, because something in it has changed

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
    bool revisited_ = false; ///< the user went back to the present step, which does not end just because it is done
};

} // namespace burin
