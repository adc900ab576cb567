// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/device_trial.h"
#include "ui/workbench/session_runner.h"
#include "ui/workbench/stylus_controller.h"

#include <optional>
#include <vector>

namespace burin {

/// Tests devices without a job: reports drivers whose library is missing, the limits that a device states, and the
/// measurements of a trial while it runs.
class DeviceTester final : public Controller {
    Q_OBJECT
public:
    static constexpr double longestTest = 120.0; ///< s

    DeviceTester(const Desk& desk, const StylusController& styluses, const SessionRunner& session, QObject* parent);

    /// Asks the drivers, in the background; `changed` when they have answered.
    void askDrivers();
    const std::vector<DriverState>& drivers() const noexcept { return drivers_; }

    /// Nobody mills, and no test runs.
    bool possible() const { return !busy_ && !session_.running(); }
    bool testing() const noexcept { return busy_; }
    /// Connects a device and reads it until `stop`, `longestTest` at most. Nothing happens where it is not possible.
    /// @param force N that it pushes up with while its first button is held; more than trialForceLimit is a fault; 0:
    /// none
    void test(const StylusController::Choice& device, double force);
    void stop();
    void forget(); ///< what was found out, and what a test that still runs finds out

    /// Of the device that was tested last; nothing: none was, or it could not be connected.
    const std::optional<StylusDescription>& description() const noexcept { return description_; }
    const std::optional<TrialFigures>& figures() const noexcept { return figures_; }
    const std::optional<Error>& fault() const noexcept { return fault_; } ///< why it could not be tested

private:
    void hear(const StylusDescription& description);
    void hear(const TrialFigures& figures);

    const StylusController& styluses_;
    const SessionRunner& session_;
    std::vector<DriverState> drivers_;
    std::optional<StylusDescription> description_;
    std::optional<TrialFigures> figures_;
    std::optional<Error> fault_;
    bool busy_ = false;
    bool heard_ = false; ///< what the test that runs says
};

} // namespace burin
