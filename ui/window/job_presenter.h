// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/step_bar.h"
#include "ui/window/presenter.h"

#include <array>

namespace burin {

/// The step bar: the state of each step, and what is missing.
class JobPresenter final : public Presenter {
    Q_OBJECT
public:
    JobPresenter(Workbench& workbench, StepBar& line, QObject* parent);
    void setShown(JobStep step);
    JobStep shown() const noexcept { return shown_; }

private:
    void present() override;
    JobStepState part() const;
    JobStepState stock() const;
    JobStepState material() const;
    JobStepState tool() const;
    JobStepState allowance() const;
    JobStepState mill() const;
    JobStepState path() const;
    JobStepState program() const;

    StepBar& line_;
    JobStep shown_ = JobStep::part;
};

} // namespace burin
