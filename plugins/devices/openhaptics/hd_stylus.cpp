// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/openhaptics/hd_stylus.h"

#include "core/device/device_thread.h"
#include "plugins/devices/openhaptics/hd_description.h"
#include "plugins/devices/openhaptics/hd_faults.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <system_error>
#include <utility>

namespace burin::openhaptics {
namespace {

constexpr int framesBetweenHeats = 100;
constexpr std::chrono::milliseconds pollEvery{2};
constexpr std::chrono::milliseconds reconnectPoll{20};

/// Enables the library's own protections, in addition to Burin's. The force itself is switched on by the first frame.
void guardCurrent(const HdApi& api) noexcept {
    for (const unsigned int capability : {hdMaximumForceClamping, hdForceRamping}) api.enable(capability);
}

} // namespace

Result<void> calibrateCurrent(const HdApi& api, const std::string& name) {
    if (api.checkCalibration() == hdCalibrationNeedsUpdate) {
        int styles = 0;
        api.getIntegerv(hdCalibrationStyles, &styles);
        // An encoder reset takes the current pose as the rest position: never without the user's consent.
        if ((static_cast<unsigned int>(styles) & hdAuto) != 0) api.updateCalibration(hdAuto);
        if ((static_cast<unsigned int>(styles) & hdInkwell) != 0) api.updateCalibration(hdInkwell);
    }
    if (api.checkCalibration() == hdCalibrated) return {};
    return Error{ErrorCode::deviceFault,
                 name,
                 {},
                 BURIN_TEXT("DeviceReason", "put its stylus into the inkwell to calibrate it").text};
}

Result<std::unique_ptr<SelfPacedStylus>> HdStylus::connect(std::shared_ptr<HdLibrary> library,
                                                           const std::string& name) {
    StylusDescription description;
    Result<void> calibrated;
    const auto prepare = [&]() -> Result<void> {
        Result<StylusDescription> described = describeCurrent(library->api, name);
        if (!described) return described.error();
        description = std::move(*described);
        calibrated = calibrateCurrent(library->api, description.name);
        guardCurrent(library->api);
        return {};
    };
    const Result<HdHandle> handle = library->scheduler.connect(name, prepare);
    if (!handle) return handle.error();
    return std::unique_ptr<SelfPacedStylus>(
        std::make_unique<HdStylus>(std::move(library), name, *handle, std::move(description), std::move(calibrated)));
}

HdStylus::HdStylus(std::shared_ptr<HdLibrary> library, std::string name, HdHandle handle, StylusDescription description,
                   Result<void> calibrated)
    : library_(std::move(library))
    , api_(library_->api)
    , name_(std::move(name))
    , handle_(handle)
    , description_(std::move(description))
    , calibrated_(std::move(calibrated)) {}

HdStylus::~HdStylus() {
    stop();
    disconnect();
}

void HdStylus::disconnect() noexcept {
    if (const HdHandle handle = handle_.exchange(hdInvalidHandle); handle != hdInvalidHandle)
        library_->scheduler.disconnect(handle);
}

std::optional<Error> HdStylus::takeFault() {
    const std::optional<DeviceFault> fault = faults_.take();
    if (!fault) return std::nullopt;
    return errorOf(*fault, description_.name);
}

DeviceHealth HdStylus::health() const noexcept {
    DeviceHealth health;
    health.connected = !lost_.load(std::memory_order_relaxed);
    health.readings = readings_.load(std::memory_order_relaxed);
    health.motorHeat = heat_.load(std::memory_order_relaxed);
    return health;
}

Result<void> HdStylus::start(StylusClient& client) {
    if (client_ != nullptr) return Error{ErrorCode::argumentInvalid, "stylus", "started", "a stylus that stands"};
    stop_ = ended_ = false;
    begun_ = false;
    forcesOff_ = true;
    frames_ = 0;
    try {
        reconnecting_ = std::thread([this] { reconnectWhenLost(); });
    } catch (const std::system_error&) {
        return Error{ErrorCode::outOfMemory, name_, {}, "no thread"};
    }
    client_ = &client;
    scheduled_ = library_->scheduler.add(called, this);
    return {};
}

void HdStylus::stop() noexcept {
    if (client_ == nullptr) return;
    stop_ = true;
    reconnecting_.join();
    const double until = steadySeconds() + stopWithin;
    while (!ended_.load(std::memory_order_acquire) && steadySeconds() < until) std::this_thread::sleep_for(pollEvery);
    const bool ended = ended_.load(std::memory_order_acquire);
    if (!ended) cutMotors(); // there was no last frame
    library_->scheduler.remove(scheduled_, ended);
    client_ = nullptr;
}

void HdStylus::cutMotors() noexcept {
    cuts_.fetch_add(1, std::memory_order_acq_rel);
    if (lost_.load(std::memory_order_relaxed)) return;
    api_.makeCurrentDevice(handle_.load());
    api_.disable(hdForceOutput);
}

unsigned int HdStylus::called(void* self) noexcept {
    return static_cast<HdStylus*>(self)->frame() ? hdContinue : hdDone;
}

/// Returns false if this was the last frame.
bool HdStylus::frame() noexcept {
    if (stops()) {
        finish();
        return false;
    }
    if (!begun_) {
        client_->begins();
        begun_ = true;
        startedAt_ = steadySeconds();
        calmFrom_ = 0.0;
    }
    const double time = steadySeconds() - startedAt_;
    if (lost_.load(std::memory_order_acquire)) {
        tickWithoutReading(time);
        return true;
    }
    const unsigned int cutsBefore = cuts_.load(std::memory_order_acquire);
    const HdHandle handle = handle_.load();
    api_.beginFrame(handle);
    const StylusState state = read(time);
    const Wrench wrench = client_->tick(state);
    api_.makeCurrentDevice(handle); // `cutMotors` of another device may have changed it
    drive(state.valid ? wrench : Wrench{}, cutsBefore);
    api_.endFrame(handle);
    takeErrors(time);
    client_->answered();
    return true;
}

void HdStylus::finish() noexcept {
    if (begun_) {
        if (!lost_.load()) {
            const HdHandle handle = handle_.load();
            api_.beginFrame(handle);
            drive({}, cuts_.load());
            api_.disable(hdForceOutput);
            api_.endFrame(handle);
        }
        client_->ends();
    }
    ended_.store(true, std::memory_order_release);
}

void HdStylus::tickWithoutReading(double time) noexcept {
    StylusState state;
    state.time = time;
    (void)client_->tick(state);
    client_->answered();
}

StylusState HdStylus::read(double time) noexcept {
    std::array<double, 16> transform{};
    int buttons = 0;
    api_.getDoublev(hdCurrentTransform, transform.data());
    api_.getIntegerv(hdCurrentButtons, &buttons);
    if (frames_++ % framesBetweenHeats == 0) {
        std::array<double, 8> motors{};
        api_.getDoublev(hdMotorTemperatures, motors.data());
        const double hottest = *std::ranges::max_element(motors);
        heat_.store(std::isfinite(hottest) ? std::clamp(hottest, 0.0, 1.0) : 0.0, std::memory_order_relaxed);
    }
    StylusState state;
    state.time = time;
    state.pose = poseOf(transform);
    state.buttons = static_cast<std::uint32_t>(buttons);
    state.motorHeat = heat_.load(std::memory_order_relaxed);
    const glm::dquat& turn = state.pose.rotation;
    state.valid =
        time >= calmFrom_ && isFinite(state.pose.position) && std::isfinite(turn.w + turn.x + turn.y + turn.z);
    if (state.valid) readings_.fetch_add(1, std::memory_order_relaxed);
    return state;
}

/// @param cutsBefore number of cuts when the pose was read: the answer to an older pose is sent as zero
void HdStylus::drive(const Wrench& wrench, unsigned int cutsBefore) noexcept {
    const bool cut = cuts_.load(std::memory_order_acquire) != cutsBefore;
    const Wrench rendered = cut ? Wrench{} : wrench;
    const std::array<double, 3> force = toHd(rendered.force);
    api_.setDoublev(hdCurrentForce, force.data());
    if (description_.actuated.rotations > 0) {
        const std::array<double, 3> torque = toHd(rendered.torque); // N·mm equals mN·m
        api_.setDoublev(hdCurrentTorque, torque.data());
    }
    if (forcesOff_ && !cut) api_.enable(hdForceOutput);
    forcesOff_ = cut;
}

void HdStylus::takeErrors(double time) noexcept {
    library_->errors.take(handle_.load(), [&](unsigned int code) {
        const std::optional<DeviceFault> fault = faultOf(code);
        if (!fault) return;
        faults_.raise(*fault);
        calmFrom_ = time + calmAfter;
        if (*fault == DeviceFault::unplugged) lost_.store(true, std::memory_order_release);
    });
}

/// The reconnecting thread: while the device is lost, tries to connect it every half second.
void HdStylus::reconnectWhenLost() noexcept {
    blockSignals();
    double lookedAt = steadySeconds();
    while (!stops()) {
        std::this_thread::sleep_for(reconnectPoll);
        if (!lost_.load(std::memory_order_acquire) || steadySeconds() - lookedAt < lookEvery) continue;
        reconnect();
        lookedAt = steadySeconds();
    }
}

void HdStylus::reconnect() noexcept {
    try {
        disconnect();
        const auto prepare = [this]() -> Result<void> {
            if (Result<void> calibrated = calibrateCurrent(api_, name_); !calibrated) {
                if (!std::exchange(uncalibratedTold_, true)) faults_.raise(DeviceFault::notCalibrated);
                return calibrated;
            }
            guardCurrent(api_);
            return {};
        };
        const Result<HdHandle> handle = library_->scheduler.connect(name_, prepare);
        if (!handle) return;
        uncalibratedTold_ = false;
        handle_.store(*handle);
        forcesOff_ = true;
        lost_.store(false, std::memory_order_release);
    } catch (const std::bad_alloc&) { // retried at the next attempt
    }
}

} // namespace burin::openhaptics
