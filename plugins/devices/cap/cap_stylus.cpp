// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/cap/cap_stylus.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace burin::cap {
namespace {

constexpr double percent = 0.01;
constexpr std::size_t upwards = 2; // in MotionShares

} // namespace

void SharedControls::publish(const Controls& controls) noexcept {
    const auto words = std::bit_cast<AxisWords>(controls.axes);
    for (std::size_t i = 0; i < words.size(); ++i) axes_[i].store(words[i], std::memory_order_relaxed);
    silent_.store(controls.silent, std::memory_order_relaxed);
    buttons_.store(controls.buttons, std::memory_order_relaxed);
    battery_.store(controls.batteryPercent, std::memory_order_relaxed);
    charging_.store(controls.charging, std::memory_order_relaxed);
}

std::array<std::int16_t, AxisMap::mostAxes> SharedControls::axes() const noexcept {
    AxisWords words;
    for (std::size_t i = 0; i < words.size(); ++i) words[i] = axes_[i].load(std::memory_order_relaxed);
    return std::bit_cast<std::array<std::int16_t, AxisMap::mostAxes>>(words);
}

CapStylus::CapStylus(std::unique_ptr<ControlSource> source, CapStylusSettings settings)
    : settings_(std::move(settings))
    , device_(std::move(source), settings_)
    , thread_(device_, settings_.name)
    , map_(settings_.map)
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
    maps_.take(map_);
    MotionShares motions{};
    if (!stale) motions = motionsOf(map_, readings());
    const std::uint32_t pressed = device_.shared().buttons();
    if (liftPressed(map_, pressed)) motions[upwards] = 1.0;
    state.pose = mapping_.advance(motions, elapsed);
    state.buttons = sessionButtons(map_, pressed);
    state.valid = thread_.connected();
    return state;
}

/// The user may have calibrated another rest than the usual one, which is published for a silent axis.
std::array<double, AxisMap::mostAxes> CapStylus::readings() const noexcept {
    std::array<double, AxisMap::mostAxes> readings = readingsOf(device_.shared().axes(), settings_.fullScale);
    const std::uint32_t silent = device_.shared().silent();
    for (std::size_t i = 0; i < readings.size(); ++i)
        if ((silent >> i & 1U) != 0) readings[i] = map_.axes[i].rest;
    return readings;
}

AxisReading CapStylus::axisReading() const noexcept {
    return {readingsOf(device_.shared().axes(), settings_.fullScale), device_.shared().buttons()};
}

void CapStylus::write(const Wrench& /*wrench*/) noexcept {}

CapStylus::Published::Published(std::unique_ptr<ControlSource> source, const CapStylusSettings& settings)
    : source_(std::move(source)), settings_(settings) {
    rest();
}

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
    for (std::size_t i = 0; i < controls_.axes.size(); ++i)
        controls_.axes[i] = static_cast<std::int16_t>(std::lround(settings_.map.axes[i].rest * settings_.fullScale));
    controls_.silent = settings_.silent;
    controls_.buttons = 0;
    controls_.keys = {};
    shared_.publish(controls_);
}

} // namespace burin::cap
