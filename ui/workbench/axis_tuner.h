// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/axis_calibration.h"
#include "core/device/axis_map_json.h"
#include "ui/workbench/stylus_controller.h"

#include <memory>
#include <optional>

namespace burin {

/// Reads the axes of a device for the dialog that assigns them, and calibrates them. Nothing is stored here.
class AxisTuner final : public Controller {
    Q_OBJECT
public:
    enum class Phase : std::uint8_t {
        away, ///< not connected, or connecting
        watching,
        resting, ///< measures the rest
        moving   ///< measures the ends, until `finish`
    };

    AxisTuner(const Desk& desk, const StylusController& styluses, QObject* parent);

    /// Connects a device in the background and reads it until `end`. @param device has an id
    void begin(const StylusController::Choice& device);
    void end();
    /// Begins a calibration. @param before the assignment in use, which stays
    void calibrate(const AxisMap& before);
    void finish();            ///< every axis was moved to its ends: `calibrated` follows
    void cancelCalibration(); ///< back to `watching`

    Phase phase() const noexcept { return phase_; }
    /// Empty until the device is connected.
    const std::optional<MappableDevice>& device() const noexcept { return device_; }
    const AxisReading& reading() const noexcept { return reading_; }
    const std::optional<Error>& fault() const noexcept { return fault_; } ///< why it is not read

signals:
    void connected(); ///< `device` is known
    void heard();     ///< `reading` or `phase` is new; about 30 times a second
    void calibrated(const burin::AxisMap& proposed);

private:
    struct Requests;
    class Watch;
    void hear(const AxisReading& reading, Phase phase);

    const StylusController& styluses_;
    std::shared_ptr<Requests> requests_; ///< of the device that is being read
    quint64 run_ = 0;                    ///< results of earlier devices are ignored
    std::optional<MappableDevice> device_;
    std::optional<Error> fault_;
    AxisReading reading_;
    Phase phase_ = Phase::away;
};

} // namespace burin
