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

    /// Queries the drivers in the background; `changed` is emitted when they have answered.
    void askDrivers();
    const std::vector<DriverState>& drivers() const noexcept { return drivers_; }

    /// Whether a test can start: no session and no test is running.
    bool possible() const { return !busy_ && !session_.running(); }
    bool testing() const noexcept { return busy_; }
    /// Connects a device and reads it until `stop`, `longestTest` at most. Does nothing unless `possible`.
    /// @param force N, upward force while the device's first button is held; more than trialForceLimit is a fault; 0:
    /// no force. @param assist ceiling of a device that assists, 0 … 1, with the same button; others ignore it
    void test(const StylusController::Choice& device, double force, double assist);
    void stop();
    void forget(); ///< Discards all results, including those of a test that is still running

    /// Of the device that was tested last; empty if none was tested or it could not be connected.
    const std::optional<StylusDescription>& description() const noexcept { return description_; }
    const std::optional<TrialFigures>& figures() const noexcept { return figures_; }
    const std::optional<Error>& fault() const noexcept { return fault_; } ///< why the device could not be tested

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
    bool heard_ = false; ///< whether results of the running test are accepted
};

} // namespace burin
