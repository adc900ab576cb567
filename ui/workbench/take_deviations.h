// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/take_deviation.h"
#include "ui/workbench/time_controller.h"

#include <memory>
#include <optional>
#include <set>

namespace burin {

/// Computes the deviation of the takes on the timeline (core/job/take_deviation.h) in the background, one take after
/// the other, while its curve is shown; the timeline gets each as soon as it is known. Cancelled: until the curve is
/// shown again.
class TakeDeviations final : public Controller {
    Q_OBJECT
public:
    TakeDeviations(const Desk& desk, const WorkpieceController& workpiece, const SessionRunner& session,
                   TimeController& time, QObject* parent);

    void setRequested(bool wanted);
    bool busy() const { return reading_ != nullptr || desk_.tasks.running(TaskKind::deviation); }
    void forget(); ///< another project

private:
    void goOn();
    std::optional<TakeInfo> next() const;
    void compute(DeviationMatter matter);
    void refuse(std::int64_t take, const Error& error);
    void stop();

    const WorkpieceController& workpiece_;
    const SessionRunner& session_;
    TimeController& time_;
    bool wanted_ = false, stopped_ = false;
    std::set<std::int64_t> failed_;     ///< takes whose deviation can't be computed
    std::shared_ptr<Progress> reading_; ///< of the poses of a take; null: they are not being read
};

} // namespace burin
