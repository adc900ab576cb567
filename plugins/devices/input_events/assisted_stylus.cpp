// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/input_events/assisted_stylus.h"

#include "core/device/device_thread.h"

#include <utility>

namespace burin::input_events {

AssistedStylus::AssistedStylus(std::unique_ptr<Stylus> stylus, std::unique_ptr<ForceWriter> writer,
                               const AssistAbilities& abilities)
    : stylus_(std::move(stylus)), writer_(std::move(writer)), abilities_(abilities), map_(stylus_->axisMap()) {}

StylusDescription AssistedStylus::description() const {
    StylusDescription description = stylus_->description();
    description.assist = abilities_;
    return description;
}

Result<void> AssistedStylus::open() {
    if (Result<void> opened = stylus_->open(); !opened) return opened;
    if (!abilities_.permitted) {
        writer_->forbid();
        return {};
    }
    Result<void> started = writer_->start();
    if (!started) stylus_->close();
    return started;
}

void AssistedStylus::close() noexcept {
    writer_->stop();
    stylus_->close();
}

std::optional<Error> AssistedStylus::takeFault() {
    if (std::optional<Error> fault = stylus_->takeFault()) return fault;
    return writer_->takeFault();
}

void AssistedStylus::assign(const AxisMap& map) noexcept {
    stylus_->assign(map);
    maps_.post(map);
}

StylusState AssistedStylus::read(double time) noexcept {
    writer_->reads();
    maps_.take(map_);
    return stylus_->read(time);
}

void AssistedStylus::write(const Wrench& wrench) noexcept {
    stylus_->write(wrench);
    writer_->post(encoded(wrench.assist, map_, abilities_), steadySeconds());
}

} // namespace burin::input_events
