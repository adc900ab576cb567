// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/force_dimension/dhd_stylus.h"

#include "core/base/units.h"
#include "core/device/device_thread.h"
#include "plugins/devices/force_dimension/dhd_models.h"

#include <chrono>
#include <cmath>
#include <system_error>
#include <utility>

namespace burin::forcedimension {
namespace {

constexpr unsigned char on = 1, off = 0;
constexpr std::chrono::milliseconds reconnectPoll{20};

/// The reason why a device switched its forces off, from the code in its state.
DeviceFault faultOfCause(int cause) noexcept {
    switch (cause) {
    case 1: // its button
    case 6: // its dead man's switch
        return DeviceFault::stopped;
    case 2:
        return DeviceFault::tooFast;
    case 3:
        return DeviceFault::watchdog;
    case 5:
        return DeviceFault::deaf;
    default:
        return DeviceFault::mechanism;
    }
}

/// Whether only the user can end this condition.
bool waitsForTheHand(int cause) noexcept {
    return cause == 1 || cause == 6;
}

} // namespace

Result<std::unique_ptr<Stylus>> DhdStylus::connect(const DhdApi& api, DhdId id, Initialisation initialisation) {
    if (api.open(id) < 0) return Error{ErrorCode::deviceNotFound, std::to_string(static_cast<int>(id)), {}, {}};
    const int type = api.getSystemType(id);
    const char* name = api.getSystemName(id);
    std::optional<StylusDescription> described = limitsOf(type);
    const std::string called = name != nullptr && *name != '\0' ? name : "Force Dimension";
    if (!described) {
        api.close(id);
        return Error{ErrorCode::deviceFault, called, {}, BURIN_TEXT("DeviceReason", "its model is not supported").text};
    }
    described->name = called;
    described->sensed = {3, api.hasWrist(id) ? 3 : 0};
    described->actuated = {3, api.hasActiveWrist(id) && described->maximumTurningStiffness.value > 0.0 ? 3 : 0};
    described->buttons = api.hasGripper(id) && api.emulateButton == nullptr ? 0 : 1;
    described->carriesHandle = true; // by its own gravity compensation
    return std::unique_ptr<Stylus>(std::make_unique<DhdStylus>(api, id, type, initialisation, std::move(*described)));
}

DhdStylus::DhdStylus(const DhdApi& api, DhdId id, int type, Initialisation initialisation,
                     StylusDescription description)
    : api_(api)
    , id_(id)
    , type_(type)
    , initialisation_(initialisation)
    , description_(std::move(description))
    , wrist_(description_.sensed.rotations > 0) {}

DhdStylus::~DhdStylus() {
    close();
    if (!closed_) api_.close(id_);
}

Result<void> DhdStylus::open() {
    if (isOpen_) return Error{ErrorCode::argumentInvalid, "stylus", "open", "a stylus that is closed"};
    if (const Result<void> initialised = initialise(); !initialised) return initialised;
    prepare();
    stop_ = false;
    try {
        reconnecting_ = std::thread([this] { reconnectWhenLost(); });
    } catch (const std::system_error&) {
        return Error{ErrorCode::outOfMemory, description_.name, {}, "no thread"};
    }
    isOpen_ = true;
    return {};
}

/// The device moves by itself during the initialisation, so this is done only if the user chose that mode.
Result<void> DhdStylus::initialise() {
    if (api_.isInitialised(id_)) return {};
    if (initialisation_ == Initialisation::refuse)
        return refusal(BURIN_TEXT("DeviceReason", "it is not calibrated; choose its self-calibrating mode"));
    const bool done = api_.autoInitialise(id_) >= 0;
    api_.stopRegulation(false, id_); // the library's own control of the device, which would work against Burin's forces
    if (done && api_.isInitialised(id_)) return {};
    return errorOf(DeviceFault::notCalibrated, description_.name);
}

/// Settings that are required before the loop may render forces. The speed limit keeps its factory setting.
void DhdStylus::prepare() noexcept {
    api_.setGravityCompensation(1, id_);
    api_.setMaximumForce(description_.maximumForce.value, id_);
    api_.setWatchdog(watchdog, id_);
    api_.setBrakes(1, id_); // active whenever its forces are off
    if (api_.hasGripper(id_) && api_.emulateButton != nullptr) api_.emulateButton(on, id_);
    enableForces();
    failures_ = reads_ = 0;
    forcesOff_ = valid_ = false;
    cutsSeen_ = cutsAtRead_ = cuts_.load();
}

/// Starts from zero: otherwise the force set before they went off would be rendered again.
void DhdStylus::enableForces() noexcept {
    api_.setForce(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, id_);
    api_.enableForce(on, id_);
}

void DhdStylus::close() noexcept {
    if (!isOpen_) return;
    stop_ = true;
    reconnecting_.join();
    if (!lost_.load()) {
        api_.setForce(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, id_);
        api_.enableForce(off, id_);
    }
    isOpen_ = false;
}

std::optional<Error> DhdStylus::takeFault() {
    const std::optional<DeviceFault> fault = faults_.take();
    if (!fault) return std::nullopt;
    return errorOf(*fault, description_.name);
}

DeviceHealth DhdStylus::health() const noexcept {
    DeviceHealth health;
    health.connected = !lost_.load(std::memory_order_relaxed);
    health.readings = readings_.load(std::memory_order_relaxed);
    return health;
}

void DhdStylus::cutMotors() noexcept {
    cuts_.fetch_add(1, std::memory_order_acq_rel);
    if (!lost_.load(std::memory_order_acquire)) api_.enableForce(off, id_);
}

StylusState DhdStylus::read(double time) noexcept {
    StylusState state;
    state.time = time;
    if (lost_.load(std::memory_order_acquire)) return state; // the other members belong to the reconnecting thread then
    valid_ = false;
    cutsAtRead_ = cuts_.load(std::memory_order_acquire);
    double x = 0.0, y = 0.0, z = 0.0;
    double rotation[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    if (api_.getPose(&x, &y, &z, rotation, id_) < 0) {
        if (++failures_ >= failuresUntilLost) lose();
        return state;
    }
    failures_ = 0;
    state.pose = poseOf(x, y, z, rotation);
    if (!wrist_) state.pose.rotation = glm::dquat(1.0, 0.0, 0.0, 0.0); // without a wrist it holds the tool upright
    state.buttons = api_.getButtons(id_);
    const glm::dquat& turn = state.pose.rotation;
    const bool finite = isFinite(state.pose.position) && std::isfinite(turn.w + turn.x + turn.y + turn.z);
    valid_ = checkState(time) && finite;
    state.valid = valid_;
    if (valid_) readings_.fetch_add(1, std::memory_order_relaxed);
    return state;
}

/// Returns whether its forces are on. Motors that were cut by the loop's watchdog are switched on again with this
/// reading.
bool DhdStylus::checkState(double time) noexcept {
    if (cutsSeen_ != cutsAtRead_) {
        cutsSeen_ = cutsAtRead_;
        enableForces();
        return !forcesOff_;
    }
    if (reads_++ % readingsBetweenChecks != 0) return !forcesOff_;
    std::array<int, dhdStatusLength> status{};
    if (api_.getStatus(status.data(), id_) < 0) return !forcesOff_;
    if (status[dhdForces] != 0) {
        forcesOff_ = false;
        return true;
    }
    const int cause = status[dhdForceOffCause];
    if (!forcesOff_) {
        forcesOff_ = true;
        triedAt_ = time;
        faults_.raise(status[dhdFailed] != 0 ? DeviceFault::mechanism : faultOfCause(cause));
    } else if (time - triedAt_ >= retryAfter && !waitsForTheHand(cause)) {
        triedAt_ = time;
        enableForces();
    }
    return false;
}

void DhdStylus::write(const Wrench& wrench) noexcept {
    if (lost_.load(std::memory_order_acquire)) return;
    const bool cut = cuts_.load(std::memory_order_acquire) != cutsAtRead_;
    const Wrench rendered = valid_ && !cut ? wrench : Wrench{};
    const glm::dvec3 force = toDhd(rendered.force);
    const glm::dvec3 torque =
        description_.actuated.rotations > 0 ? toDhd(rendered.torque) / millimetresPerMetre : glm::dvec3(0.0); // N·m
    if (api_.setForce(force.x, force.y, force.z, torque.x, torque.y, torque.z, 0.0, id_) < 0)
        faults_.raise(DeviceFault::deaf);
}

void DhdStylus::lose() noexcept {
    lost_.store(true, std::memory_order_release);
    faults_.raise(DeviceFault::unplugged);
}

/// The reconnecting thread: while the device is lost, tries to open it every half second.
void DhdStylus::reconnectWhenLost() noexcept {
    blockSignals();
    auto lookedAt = std::chrono::steady_clock::now();
    while (!stop_.load(std::memory_order_relaxed)) {
        std::this_thread::sleep_for(reconnectPoll);
        const auto now = std::chrono::steady_clock::now();
        if (!lost_.load(std::memory_order_acquire) || now - lookedAt < std::chrono::duration<double>(lookEvery))
            continue;
        lookedAt = now;
        if (!std::exchange(closed_, true)) api_.close(id_);
        connectAgain();
    }
}

/// Another model in its place is not used, nor a device whose encoders are not initialised: nobody has allowed it to
/// move.
void DhdStylus::connectAgain() noexcept {
    if (api_.open(id_) < 0) return;
    if (api_.getSystemType(id_) != type_ || !api_.isInitialised(id_)) {
        api_.close(id_);
        return;
    }
    closed_ = false;
    prepare();
    lost_.store(false, std::memory_order_release);
}

} // namespace burin::forcedimension
