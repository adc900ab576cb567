// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/coach/coach_panel.h"
#include "ui/coach/first_job.h"
#include "ui/coach/pointed.h"

namespace burin {

class TargetOutline;

/// Guides a new user through the first job: says what to do next and points at it, but never does it itself.
class Coach final : public QObject {
    Q_OBJECT
public:
    Coach(QWidget& window, Workbench& workbench, const Actions& actions); ///< all outlive it
    ~Coach() override;

    void begin();
    void end();
    bool running() const noexcept { return job_.running(); }
    bool hasKeyboard() const;
    void takeKeyboard();
    void setUnit(LengthUnit unit);
    const FirstJob& job() const noexcept { return job_; }
    /// What the user should press now; nothing while Burin is busy, and after the last step.
    const Pointed& pointed() const noexcept { return pointed_; }

    bool eventFilter(QObject* watched, QEvent* event) override;

signals:
    void finished(); ///< all steps are completed or skipped

private:
    void followSoon();
    void follow();
    void point();
    CoachState state() const;
    CoachState stateOf(const FirstJobStep& step) const;
    QString note() const;
    QString keyOf(ActionId id) const;
    bool busy() const;
    QWidget& place() const;

    QWidget& window_;
    Workbench& workbench_;
    const Actions& actions_;
    FirstJob job_;
    CoachPanel* panel_;
    QPointer<TargetOutline> outline_; ///< deleted with a menu that it lies over
    Pointed pointed_;
    std::size_t pointedFor_ = 0; ///< the step that `pointed_` belongs to
    CoachState said_;
    LengthUnit unit_ = LengthUnit::millimetre;
    bool due_ = false;
};

} // namespace burin
