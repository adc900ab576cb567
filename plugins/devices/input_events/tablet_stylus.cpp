// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/input_events/tablet_stylus.h"

#include <algorithm>
#include <cmath>

namespace burin::input_events {
namespace {

constexpr int penButtons = 4; // its tip, and at most three on its barrel

} // namespace

TabletStylus::TabletStylus(ReopenedPort port, std::string name)
    : name_(std::move(name)), device_(std::move(port)), thread_(device_, name_) {}

StylusDescription TabletStylus::description() const {
    const std::string mapping = "Burin's mapping of the pen";
    const TabletReader& tablet = device_.reader();
    const std::string size = tablet.statesSize() ? "the tablet" : "Burin: assumed, as the tablet states no size";
    StylusDescription description;
    description.name = name_;
    description.sensed = {3, tablet.leans() ? 2 : 0};
    description.buttons = penButtons;
    description.workspaceRadius = {0.5 * std::hypot(tablet.width(), tablet.height()), size};
    description.positionStep = {tablet.step(), size};
    description.maximumSpeed = {2.0 * PenMapping::followSpeed, mapping};
    return description;
}

Result<void> TabletStylus::open() {
    if (Result<void> started = thread_.start(); !started) return started;
    mapping_.reset();
    readAt_.reset();
    return {};
}

StylusState TabletStylus::read(double time) noexcept {
    (void)device_.take(pen_);
    maps_.take(map_);
    const double elapsed = readAt_ ? std::max(0.0, time - *readAt_) : 0.0;
    readAt_ = time;
    StylusState state;
    state.time = time;
    const Pen used = mappedPen(pen_, map_, device_.reader());
    state.pose = mapping_.advance(used, elapsed);
    state.buttons = used.buttons;
    state.valid = thread_.connected();
    return state;
}

void TabletStylus::write(const Wrench& /*wrench*/) noexcept {}

polled::PolledDevice::Heard TabletStylus::Published::receive(int milliseconds) noexcept {
    input_event event;
    const EventPort::Heard heard = port_.next(event, milliseconds);
    if (heard != EventPort::Heard::event) return heard == EventPort::Heard::gone ? Heard::gone : Heard::nothing;
    if (!reader_.take(event)) return Heard::nothing;
    publish();
    return Heard::news;
}

void TabletStylus::Published::rest() noexcept {
    reader_.rest();
    publish();
}

void TabletStylus::Published::publish() noexcept {
    pens_.post(reader_.pen());
    const AxisReading reading = readingOf(reader_.pen(), reader_);
    for (std::size_t i = 0; i < values_.size(); ++i) values_[i].store(reading.values[i], std::memory_order_relaxed);
    buttons_.store(reading.buttons, std::memory_order_relaxed);
}

AxisReading TabletStylus::Published::newest() const noexcept {
    AxisReading reading;
    for (std::size_t i = 0; i < values_.size(); ++i) reading.values[i] = values_[i].load(std::memory_order_relaxed);
    reading.buttons = buttons_.load(std::memory_order_relaxed);
    return reading;
}

} // namespace burin::input_events
