// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/job_states.h"

#include <QWidget>

#include <array>

namespace burin {

/// The step bar: the steps of the job, always visible, each with its state. Every step can be opened at any time.
class StepBar : public QWidget {
    Q_OBJECT
public:
    static constexpr int steps = 8;
    explicit StepBar(QWidget* parent = nullptr);
    void setState(const std::array<JobStepState, steps>& states, JobStep shown);

signals:
    void stepChosen(burin::JobStep step);

private:
    class Fields;
    Fields* fields_ = nullptr;
};

} // namespace burin
