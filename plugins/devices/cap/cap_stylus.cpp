// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/cap/cap_stylus.h"

#include "core/device/device_thread.h"

#include <algorithm>
#include <chrono>
#include <system_error>

namespace burin::cap {
namespace {

constexpr int waitMilliseconds = 20; // so long `close` may have to wait
constexpr double percent = 0.01;

std::uint64_t packed(const std::array<std::int16_t, 6>& axes, std::size_t first) noexcept {
    std::uint64_t word = 0;
    for (std::size_t i = 0; i < 3; ++i)
        word |= static_cast<std::uint64_t>(static_cast<std::uint16_t>(axes[first + i])) << (16 * i);
    return word;
}

void unpack(std::uint64_t word, std::array<std::int16_t, 6>& axes, std::size_t first) noexcept {
    for (std::size_t i = 0; i < 3; ++i)
        axes[first + i] = static_cast<std::int16_t>(static_cast<std::uint16_t>(word >> (16 * i) & 0xffffU));
}

} // namespace

void SharedControls::publish(const Controls& controls) noexcept {
    translation_.store(packed(controls.axes, 0), std::memory_order_relaxed);
    rotation_.store(packed(controls.axes, 3), std::memory_order_relaxed);
    buttons_.store(controls.buttons, std::memory_order_relaxed);
    battery_.store(controls.batteryPercent, std::memory_order_relaxed);
    charging_.store(controls.charging, std::memory_order_relaxed);
}

std::array<std::int16_t, 6> SharedControls::axes() const noexcept {
    std::array<std::int16_t, 6> axes{};
    unpack(translation_.load(std::memory_order_relaxed), axes, 0);
    unpack(rotation_.load(std::memory_order_relaxed), axes, 3);
    return axes;
}

CapStylus::CapStylus(std::unique_ptr<ControlSource> source, CapStylusSettings settings)
    : source_(std::move(source)), settings_(std::move(settings)), mapping_(settings_.mode) {}

StylusDescription CapStylus::description() const {
    const std::string mapping = "Burin's mapping of the cap";
    StylusDescription description;
    description.name = settings_.name;
    description.buttons = settings_.buttons;
    description.workspaceRadius = {CapMapping::workspaceRadius, mapping};
    description.rate = settings_.rate;
    description.maximumSpeed = {2.0 * CapMapping::followSpeed, mapping};
    return description;
}

Result<void> CapStylus::open() {
    if (thread_.joinable()) return Error{ErrorCode::argumentInvalid, "stylus", "open", "a stylus that is closed"};
    stop_.store(false, std::memory_order_relaxed);
    mapping_.reset();
    readAt_.reset();
    motions_ = shared_.motions();
    movedAt_ = -2.0 * settings_.staleAfter;
    try {
        thread_ = std::thread([this] { run(); });
    } catch (const std::system_error&) {
        return Error{ErrorCode::outOfMemory, settings_.name, {}, "no thread"};
    }
    return {};
}

void CapStylus::close() noexcept {
    if (!thread_.joinable()) return;
    stop_.store(true, std::memory_order_relaxed);
    thread_.join();
}

std::optional<Error> CapStylus::takeFault() {
    const std::optional<DeviceFault> fault = faults_.take();
    if (!fault) return std::nullopt;
    return errorOf(*fault, settings_.name);
}

DeviceHealth CapStylus::health() const noexcept {
    DeviceHealth health;
    health.connected = connected_.load(std::memory_order_relaxed);
    health.readings = readings_.load(std::memory_order_relaxed);
    if (const int battery = shared_.batteryPercent(); battery >= 0) health.batteryShare = percent * battery;
    health.charging = shared_.charging();
    return health;
}

StylusState CapStylus::read(double time) noexcept {
    if (const std::uint64_t motions = shared_.motions(); motions != motions_) {
        motions_ = motions;
        movedAt_ = time;
    }
    const bool stale = settings_.staleAfter > 0.0 && time - movedAt_ > settings_.staleAfter;
    const double elapsed = readAt_ ? std::max(0.0, time - *readAt_) : 0.0;
    readAt_ = time;
    StylusState state;
    state.time = time;
    state.pose = mapping_.advance(stale ? std::array<std::int16_t, 6>{} : shared_.axes(), elapsed);
    state.buttons = shared_.buttons();
    state.valid = connected_.load(std::memory_order_relaxed);
    return state;
}

void CapStylus::write(const Wrench& /*wrench*/) noexcept {}

void CapStylus::run() noexcept {
    blockSignals();
    while (runs()) {
        if (source_->connect()) {
            connected_.store(true, std::memory_order_relaxed);
            receive();
            continue;
        }
        const auto until = std::chrono::steady_clock::now() + std::chrono::duration<double>(lookEvery);
        while (runs() && std::chrono::steady_clock::now() < until)
            std::this_thread::sleep_for(std::chrono::milliseconds(waitMilliseconds));
    }
    source_->disconnect();
}

/// Until the device is gone, or nobody wants it any more.
void CapStylus::receive() noexcept {
    Controls controls;
    while (runs()) {
        const ControlSource::Heard heard = source_->receive(controls, waitMilliseconds);
        if (heard == ControlSource::Heard::nothing) continue;
        if (heard == ControlSource::Heard::gone) break;
        readings_.fetch_add(1, std::memory_order_relaxed);
        shared_.publish(controls);
        if (heard == ControlSource::Heard::motion) shared_.heardMotion();
    }
    if (!runs()) return;
    source_->disconnect();
    Controls rest = controls; // the battery's charge is known as before
    rest.axes = {};
    rest.buttons = 0;
    rest.keys = {};
    shared_.publish(rest);
    connected_.store(false, std::memory_order_relaxed);
    faults_.raise(DeviceFault::unplugged);
}

} // namespace burin::cap
