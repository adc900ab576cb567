// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/device_tester.h"

#include <QMetaObject>

#include <utility>

namespace burin {

DeviceTester::DeviceTester(const Desk& desk, const StylusController& styluses, const SessionRunner& session,
                           QObject* parent)
    : Controller(desk, parent), styluses_(styluses), session_(session) {}

void DeviceTester::askDrivers() {
    desk_.tasks.start(
        TaskKind::drivers, tr("Looking for devices"),
        [registry = styluses_.registry()](Progress&) -> Result<std::vector<DriverState>> {
            return registry ? registry->drivers() : std::vector<DriverState>{};
        },
        [this](Result<std::vector<DriverState>> drivers) {
            if (!drivers) return;
            drivers_ = std::move(*drivers);
            emit changed();
        });
}

void DeviceTester::test(const StylusController::Choice& device, double force, double assist) {
    if (!possible() || device.id.empty()) return;
    forget();
    busy_ = heard_ = true;
    const auto report = [this](auto news) {
        QMetaObject::invokeMethod(
            this, [this, news = std::move(news)] { hear(news); }, Qt::QueuedConnection);
    };
    desk_.tasks.start(
        TaskKind::deviceTest, tr("Testing %1").arg(device.name),
        [registry = styluses_.registry(), map = styluses_.axisMap(device.id), device, force, assist,
         report](Progress& progress) -> Result<TrialFigures> {
            const Result<AnyStylus> stylus = StylusController::make(registry, device.id, device.mode, map);
            if (!stylus) return stylus.error();
            const StylusDescription description = StylusHandle(*stylus).device().description();
            report(description);
            TrialSettings settings;
            settings.seconds = longestTest;
            settings.force = force;
            settings.assist = description.assist.works() ? assist : 0.0;
            settings.report = report;
            return tryDevice(StylusHandle(*stylus), settings, progress);
        },
        [this](Result<TrialFigures> figures) {
            busy_ = false;
            if (heard_ && figures) figures_ = std::move(*figures);
            if (heard_ && !figures && figures.error().code != ErrorCode::cancelled) fault_ = figures.error();
            emit changed();
        });
    emit changed();
}

void DeviceTester::hear(const StylusDescription& description) {
    if (!busy_ || !heard_) return;
    description_ = description;
    emit changed();
}

void DeviceTester::hear(const TrialFigures& figures) {
    if (!busy_ || !heard_) return;
    figures_ = figures;
    emit changed();
}

void DeviceTester::stop() {
    desk_.tasks.cancel(TaskKind::deviceTest);
}

void DeviceTester::forget() {
    heard_ = false;
    description_.reset();
    figures_.reset();
    fault_.reset();
}

} // namespace burin
