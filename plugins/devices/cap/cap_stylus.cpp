// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/cap/cap_stylus.h"

#include <algorithm>

namespace burin::cap {
namespace {

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
    : settings_(std::move(settings))
    , device_(std::move(source))
    , thread_(device_, settings_.name)
    , mapping_(settings_.mode) {}

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
    const std::uint64_t motions = device_.shared().motions(); // motions received from now on are new
    if (Result<void> started = thread_.start(); !started) return started;
    mapping_.reset();
    readAt_.reset();
    motions_ = motions;
    movedAt_ = -2.0 * settings_.staleAfter;
    return {};
}

DeviceHealth CapStylus::health() const noexcept {
    DeviceHealth health = thread_.health();
    if (const int battery = device_.shared().batteryPercent(); battery >= 0) health.batteryShare = percent * battery;
    health.charging = device_.shared().charging();
    return health;
}

StylusState CapStylus::read(double time) noexcept {
    if (const std::uint64_t motions = device_.shared().motions(); motions != motions_) {
        motions_ = motions;
        movedAt_ = time;
    }
    const bool stale = settings_.staleAfter > 0.0 && time - movedAt_ > settings_.staleAfter;
    const double elapsed = readAt_ ? std::max(0.0, time - *readAt_) : 0.0;
    readAt_ = time;
    StylusState state;
    state.time = time;
    state.pose = mapping_.advance(stale ? std::array<std::int16_t, 6>{} : device_.shared().axes(), elapsed);
    state.buttons = device_.shared().buttons();
    state.valid = thread_.connected();
    return state;
}

void CapStylus::write(const Wrench& /*wrench*/) noexcept {}

polled::PolledDevice::Heard CapStylus::Published::receive(int milliseconds) noexcept {
    const ControlSource::Heard heard = source_->receive(controls_, milliseconds);
    if (heard == ControlSource::Heard::nothing) return Heard::nothing;
    if (heard == ControlSource::Heard::gone) return Heard::gone;
    shared_.publish(controls_);
    if (heard == ControlSource::Heard::motion) shared_.heardMotion();
    return Heard::news;
}

void CapStylus::Published::rest() noexcept {
    // The battery state is kept.
    controls_.axes = {};
    controls_.buttons = 0;
    controls_.keys = {};
    shared_.publish(controls_);
}

} // namespace burin::cap
