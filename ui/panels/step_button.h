// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/job_states.h"

#include <QAbstractButton>

namespace burin {

/// One step of the step bar: its number in a circle, or a tick; its title; and below it a line with its state.
class StepButton : public QAbstractButton {
    Q_OBJECT
public:
    StepButton(JobStep step, const QString& title, QWidget* parent = nullptr);
    void setState(const JobStepState& state, bool shown);
    JobStep step() const noexcept { return step_; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    bool event(QEvent* event) override;

private:
    void paintCircle(QPainter& painter, const QRectF& circle) const;
    QFont titleFont() const;
    QFont lineFont() const;
    QRect textRect() const;

    JobStep step_;
    JobStepState state_;
    bool shown_ = false;
};

} // namespace burin
