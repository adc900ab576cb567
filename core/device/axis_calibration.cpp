// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/device/axis_calibration.h"

#include "core/device/device_thread.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>
#include <utility>

namespace burin {
namespace {

constexpr std::chrono::milliseconds betweenReadings{5};
constexpr double mostDeadZone = 0.5;

} // namespace

AxisCalibration::AxisCalibration(std::vector<DeviceAxis> axes, const AxisMap& before)
    : axes_(std::move(axes)), before_(before), sums_(axes_.size()) {}

void AxisCalibration::rest(const AxisReading& reading) {
    ++restCount_;
    for (std::size_t i = 0; i < sums_.size(); ++i) {
        const double off = reading.values[i] - sums_[i].mean;
        sums_[i].mean += off / static_cast<double>(restCount_);
        sums_[i].squares += off * (reading.values[i] - sums_[i].mean);
    }
}

void AxisCalibration::move(const AxisReading& reading) {
    const bool first = moveCount_++ == 0;
    for (std::size_t i = 0; i < sums_.size(); ++i) {
        sums_[i].low = first ? reading.values[i] : std::min(sums_[i].low, reading.values[i]);
        sums_[i].high = first ? reading.values[i] : std::max(sums_[i].high, reading.values[i]);
    }
}

AxisCalibration::Measured AxisCalibration::measured(std::size_t axis) const {
    const Sums& sums = sums_[axis];
    const double count = static_cast<double>(restCount_);
    return {sums.mean, restCount_ > 1 ? std::sqrt(sums.squares / (count - 1.0)) : 0.0, sums.low, sums.high};
}

AxisMap AxisCalibration::proposed() const {
    AxisMap map = before_;
    if (!complete()) return map;
    for (std::size_t i = 0; i < axes_.size(); ++i) {
        AxisUse& use = map.axes[i];
        const Measured seen = measured(i);
        if (use.rest - seen.low > leastMotion * (use.rest - use.low)) use.low = seen.low;
        if (seen.high - use.rest > leastMotion * (use.high - use.rest)) use.high = seen.high;
        if (!axes_[i].springs) {
            use.rest = axes_[i].oneSided ? use.low : 0.5 * (use.low + use.high);
            use.deadZone = 0.0;
            continue;
        }
        if (seen.allZero()) continue;
        use.rest = std::clamp(seen.rest, use.low, use.high);
        if (axes_[i].oneSided) use.low = use.rest;
        if (!(use.low < use.high)) { // it was held at its end when it should have rested
            use = before_.axes[i];
            continue;
        }
        const double down = use.rest - use.low, up = use.high - use.rest;
        const double range = down > 0.0 && up > 0.0 ? std::min(down, up) : std::max(down, up);
        use.deadZone =
            range > 0.0 ? std::clamp(sigmas * seen.noise / range, leastDeadZone, mostDeadZone) : mostDeadZone;
    }
    return map;
}

Result<void> watchAxes(const StylusHandle& stylus, const std::function<bool(const AxisReading&, double)>& heard,
                       Progress& progress) {
    StylusDevice& device = stylus.device();
    if (device.axes().empty())
        return Error{ErrorCode::argumentInvalid, "device", device.description().name, "a device with axes to assign"};
    if (Result<void> opened = device.open(); !opened) return opened;
    const double start = steadySeconds();
    Result<void> outcome;
    while (!progress.cancelled()) {
        if (std::optional<Error> fault = device.takeFault()) {
            outcome = std::move(*fault);
            break;
        }
        if (!heard(device.axisReading(), steadySeconds() - start)) break;
        std::this_thread::sleep_for(betweenReadings);
    }
    device.close();
    if (progress.cancelled()) return Error{ErrorCode::cancelled, device.description().name, {}, {}};
    return outcome;
}

} // namespace burin
