// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/axis_tuner.h"

#include "core/base/mailbox.h"

#include <QMetaObject>

#include <atomic>
#include <utility>

namespace burin {

namespace {

constexpr double betweenReports = 0.033; // s

} // namespace

/// From the window to the thread that reads.
struct AxisTuner::Requests {
    Mailbox<AxisMap> calibrate; ///< begins a calibration with this assignment
    std::atomic<bool> finish{false}, cancel{false};
};

/// Sorts the readings of one device into a calibration, on the thread that reads.
class AxisTuner::Watch {
public:
    Watch(MappableDevice device, std::shared_ptr<Requests> requests)
        : device_(std::move(device)), requests_(std::move(requests)) {}

    /// @return the proposal of a calibration that was finished with this reading
    std::optional<AxisMap> take(const AxisReading& reading, double seconds) {
        if (AxisMap before; requests_->calibrate.take(before)) {
            requests_->finish = requests_->cancel = false;
            calibration_.emplace(device_.axes, before);
            restUntil_ = seconds + AxisCalibration::restSeconds;
        }
        if (requests_->cancel.exchange(false)) calibration_.reset();
        if (!calibration_) {
            phase_ = Phase::watching;
            return std::nullopt;
        }
        phase_ = seconds < restUntil_ ? Phase::resting : Phase::moving;
        if (phase_ == Phase::resting)
            calibration_->rest(reading);
        else
            calibration_->move(reading);
        if (phase_ == Phase::resting || !requests_->finish.exchange(false)) return std::nullopt;
        const AxisMap proposed = calibration_->proposed();
        calibration_.reset();
        phase_ = Phase::watching;
        return proposed;
    }
    bool isDue(double seconds) {
        if (seconds < dueAt_) return false;
        dueAt_ = seconds + betweenReports;
        return true;
    }
    Phase phase() const noexcept { return phase_; }

private:
    MappableDevice device_;
    std::shared_ptr<Requests> requests_;
    std::optional<AxisCalibration> calibration_;
    double restUntil_ = 0.0, dueAt_ = 0.0; ///< s
    Phase phase_ = Phase::watching;
};

AxisTuner::AxisTuner(const Desk& desk, const StylusController& styluses, QObject* parent)
    : Controller(desk, parent), styluses_(styluses) {}

void AxisTuner::begin(const StylusController::Choice& device) {
    end();
    requests_ = std::make_shared<Requests>();
    const auto inWindow = [this, run = run_](auto change) {
        QMetaObject::invokeMethod(
            this,
            [this, run, change = std::move(change)] {
                if (run == run_) change();
            },
            Qt::QueuedConnection);
    };
    desk_.tasks.start(
        TaskKind::axes, tr("Reading the axes of %1").arg(device.name),
        [this, registry = styluses_.registry(), device, requests = requests_,
         inWindow](Progress& progress) -> Result<bool> {
            // Not with the kept assignment, which may be what is wrong: readings are the same.
            const Result<AnyStylus> stylus = StylusController::make(registry, device.id, device.mode, {});
            if (!stylus) return stylus.error();
            const StylusHandle handle(*stylus);
            const MappableDevice mappable = mappableOf(handle.device());
            if (mappable.axes.empty())
                return Error{ErrorCode::argumentInvalid, "device", mappable.name, "a device with axes to assign"};
            inWindow([this, mappable] {
                device_ = mappable;
                emit connected();
            });
            Watch watch(mappable, requests);
            const auto hearAxes = [&](const AxisReading& reading, double seconds) {
                if (const std::optional<AxisMap> proposed = watch.take(reading, seconds))
                    inWindow([this, map = *proposed] { emit calibrated(map); });
                if (watch.isDue(seconds)) inWindow([this, reading, phase = watch.phase()] { hear(reading, phase); });
                return true;
            };
            const Result<void> watched = watchAxes(handle, hearAxes, progress);
            if (!watched) return watched.error();
            return true;
        },
        [this, run = run_](const Result<bool>& watched) {
            if (run != run_) return;
            phase_ = Phase::away;
            if (!watched && watched.error().code != ErrorCode::cancelled) fault_ = watched.error();
            emit changed();
        });
    emit changed();
}

void AxisTuner::end() {
    ++run_;
    if (desk_.tasks.running(TaskKind::axes)) desk_.tasks.abandon(TaskKind::axes);
    requests_.reset();
    device_.reset();
    fault_.reset();
    reading_ = {};
    phase_ = Phase::away;
}

void AxisTuner::hear(const AxisReading& reading, Phase phase) {
    reading_ = reading;
    phase_ = phase;
    emit heard();
}

void AxisTuner::calibrate(const AxisMap& before) {
    if (requests_ && phase_ == Phase::watching) requests_->calibrate.post(before);
}

void AxisTuner::finish() {
    if (requests_) requests_->finish = true;
}

void AxisTuner::cancelCalibration() {
    if (requests_) requests_->cancel = true;
}

} // namespace burin
