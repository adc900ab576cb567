// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/hand_controller.h"

#include "ui/workbench/value_command.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin {

namespace {

constexpr const char* rateMode = "rate"; // mode of drivers whose devices do rate control themselves
constexpr double smallestScale = 0.05, largestScale = 50.0;

std::string nameOf(const StylusController& styluses) {
    const StylusController::Choice& chosen = styluses.choices()[styluses.chosen()];
    return chosen.id + ' ' + chosen.mode;
}

std::uint32_t bitOf(int button) {
    return button > 0 && button <= 32 ? 1U << static_cast<unsigned>(button - 1) : 0U;
}

} // namespace

HandController::HandController(const Desk& desk, WorkpieceController& workpiece, MillController& mill,
                               SessionRunner& session, StylusController& styluses, GuideController& guides,
                               QObject* parent)
    : Controller(desk, parent)
    , workpiece_(workpiece)
    , mill_(mill)
    , session_(session)
    , styluses_(styluses)
    , guides_(guides) {
    connect(&mill_, &MillController::entered, this, [this] { useDevice(mill_.device()); });
    connect(&mill_, &MillController::left, this, [this] { useDevice({}); });
    connect(&styluses_, &Controller::changed, this, [this] {
        prepare();
        emit changed();
    });
    connect(&session_, &SessionRunner::healthRead, this, &HandController::watch);
}

void HandController::useDevice(const std::optional<HandDevice>& device) {
    device_ = device;
    if (!device_) clutched_ = batteryTold_ = false;
    prepare();
    apply();
    emit changed();
}

bool HandController::canRate() const {
    return hasDevice() && !device_->description.hasMotors() && styluses_.choices()[styluses_.chosen()].mode != rateMode;
}

std::size_t HandController::kept() {
    const std::string device = nameOf(styluses_);
    const auto found = std::ranges::find(kept_, device, &Kept::device);
    if (found != kept_.end()) return static_cast<std::size_t>(found - kept_.begin());
    kept_.push_back({device, {}});
    return kept_.size() - 1;
}

const HandSettings& HandController::settings() const {
    static const HandSettings none;
    const auto found = std::ranges::find(kept_, nameOf(styluses_), &Kept::device);
    return found == kept_.end() ? none : found->settings;
}

void HandController::change(const QString& title, const HandSettings& settings, bool merged) {
    const std::size_t device = kept();
    const HandSettings before = kept_[device].settings;
    if (!hasDevice() || settings == before) return;
    desk_.undo.push(
        new ValueCommand<HandSettings>(title, merged ? handValue + static_cast<int>(device) : -1, before, settings,
                                       [this, device](const HandSettings& wanted) { set(device, wanted); }));
}

/// An entry of the undo stack may belong to a disconnected device, which gets its settings when it is connected again.
void HandController::set(std::size_t device, const HandSettings& settings) {
    kept_[device].settings = settings;
    prepare();
    apply();
    emit changed();
}

/// Sets what a session needs when it begins, and the guides.
void HandController::prepare() {
    const HandSettings& wanted = settings();
    const bool mouse = styluses_.mouse();
    guides_.setStepButtons(mouse ? 0 : bitOf(wanted.levelButton));
    mill_.setForceButtons(mouse ? 0 : bitOf(wanted.forceButton));
}

void HandController::apply() {
    if (!hasDevice()) return;
    const HandSettings& wanted = settings();
    WorkspaceSettings workspace;
    workspace.scale = wanted.scale.value_or(device_->mapping.scale);
    workspace.rotation = wanted.rotation.value_or(device_->mapping.rotation);
    workspace.clutched = clutched_;
    workspace.clutchButton = bitOf(wanted.clutchButton);
    workspace.recentrings = recentrings_;
    if (canRate()) workspace.control = wanted.control;
    if (workspace.control == WorkspaceControl::rate) workspace.region = workpiece_.milling()->tipRegion();
    session_.setWorkspace(workspace);
}

void HandController::setClutched(bool clutched) {
    if (!hasDevice() || clutched == clutched_) return;
    clutched_ = clutched;
    apply();
    emit changed();
}

void HandController::recentre() {
    if (!hasDevice()) return;
    ++recentrings_;
    apply();
    emit changed();
}

void HandController::setScale(double scale) {
    HandSettings wanted = settings();
    wanted.scale = std::clamp(scale, smallestScale, largestScale);
    change(tr("scale of the hand"), wanted, true);
}

void HandController::scaleBy(double factor) {
    if (hasDevice()) setScale(settings().scale.value_or(device_->mapping.scale) * factor);
}

void HandController::alignWith(const glm::dvec3& right) {
    HandSettings wanted = settings();
    wanted.rotation = glm::angleAxis(std::atan2(right.y, right.x), glm::dvec3(0.0, 0.0, 1.0));
    change(tr("alignment of the hand"), wanted);
}

void HandController::setControl(WorkspaceControl control) {
    if (!canRate()) return;
    HandSettings wanted = settings();
    wanted.control = control;
    change(tr("control of the hand"), wanted);
}

void HandController::setClutchButton(int button) {
    HandSettings wanted = settings();
    wanted.clutchButton = button;
    change(tr("clutch button"), wanted);
}

void HandController::setLevelButton(int button) {
    HandSettings wanted = settings();
    wanted.levelButton = button;
    change(tr("level button"), wanted);
}

void HandController::setForceButton(int button) {
    HandSettings wanted = settings();
    wanted.forceButton = button;
    change(tr("force button"), wanted);
}

void HandController::watch() {
    if (!hasDevice()) return;
    const double battery = health().charging ? 1.0 : health().batteryShare.value_or(1.0);
    if (battery > fineBattery) batteryTold_ = false;
    if (battery <= lowBattery && !std::exchange(batteryTold_, true)) emit batteryLow(battery);
    emit changed();
}

} // namespace burin
