// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/device/stylus_handle.h"

#include <functional>
#include <vector>

namespace burin {

/// Measures the axes of a device, first at rest and then in motion, and proposes their calibration. One thread.
class AxisCalibration {
public:
    static constexpr double restSeconds = 2.0; ///< how long the device has to rest
    static constexpr double sigmas = 3.0;      ///< the proposed dead zone, standard deviations of the noise at rest
    /// Smallest dead zone, share of the deflection: a spring does not bring an axis back to exactly the same reading.
    static constexpr double leastDeadZone = 0.01;
    /// Share of the previous range, in one direction, that an axis has to be moved for its end to be taken as new.
    static constexpr double leastMotion = 0.25;

    /// The measurements of one axis, readings.
    struct Measured {
        double rest = 0.0, noise = 0.0; ///< mean and standard deviation at rest
        double low = 0.0, high = 0.0;   ///< farthest readings in motion
        /// Whether all readings at rest were 0: perhaps the device reports the axis only once it was moved.
        bool allZero() const noexcept { return rest == 0.0 && noise == 0.0; }
    };

    /// @param axes of the device @param before the map in use, whose assignments are kept
    AxisCalibration(std::vector<DeviceAxis> axes, const AxisMap& before);

    void rest(const AxisReading& reading); ///< a reading of the device at rest
    void move(const AxisReading& reading); ///< a reading while the user moves every axis to its ends
    bool complete() const noexcept { return restCount_ > 0 && moveCount_ > 0; }
    Measured measured(std::size_t axis) const;
    /// The map with new rests, ends and dead zones. An axis that springs back gets its mean at rest and the dead zone
    /// of `sigmas` deviations of its noise, as a share of the smaller of its two ranges; one that stays where it is
    /// rests in the middle of its range, or at its lower end, without a dead zone. An end that was not reached stays;
    /// an axis that would have no range left keeps its calibration. Rest and dead zone stay where every reading at rest
    /// was exactly 0: many devices report an axis only once it was moved.
    AxisMap proposed() const;

private:
    /// Welford's sums.
    struct Sums {
        double mean = 0.0, squares = 0.0;
        double low = 0.0, high = 0.0;
    };
    std::vector<DeviceAxis> axes_;
    AxisMap before_;
    std::vector<Sums> sums_;
    std::size_t restCount_ = 0, moveCount_ = 0;
};

/// Opens a device with axes, reports its readings 200 times a second on the caller's thread, which it blocks, and
/// closes it. Errors: argumentInvalid (no axes), cancelled, those of StylusDevice::open and takeFault.
/// @param heard gets each reading and the time since the start, s; returns false to end
Result<void> watchAxes(const StylusHandle& stylus, const std::function<bool(const AxisReading&, double)>& heard,
                       Progress& progress);

} // namespace burin
