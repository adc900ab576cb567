// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/input_events/force_writer.h"

#include "core/device/device_thread.h"

#include <cerrno>
#include <chrono>
#include <exception>
#include <thread>
#include <utility>

namespace burin::input_events {

ForceWriter::ForceWriter(OpenEffectPort open, const ForceAbilities& abilities, std::string name, std::string node)
    : open_(std::move(open)), abilities_(abilities), name_(std::move(name)), node_(std::move(node)) {}

Result<void> ForceWriter::start() {
    if (!thread_.started()) {
        openAt_ = 0.0;
        failing_ = false;
    }
    return thread_.start(name_, [this] { run(); });
}

std::optional<Error> ForceWriter::takeFault() {
    const std::optional<ForceFault> fault = faults_.take();
    if (!fault) return std::nullopt;
    if (*fault == ForceFault::notAllowed) return Error{ErrorCode::deviceAssistDenied, name_, node_, {}};
    return errorOf(DeviceFault::deaf, name_);
}

void ForceWriter::run() noexcept {
    blockSignals();
    while (thread_.runs()) {
        step(steadySeconds());
        std::this_thread::sleep_for(std::chrono::duration<double>(cycle));
    }
    close();
}

void ForceWriter::step(double now) noexcept {
    cues_.take(cue_);
    const bool counts = now - cue_.at <= staleAfter && cue_.cuts == cuts_.load(std::memory_order_acquire);
    const EffectLevels levels = counts ? cue_.levels : EffectLevels{};
    if (levels.ceiling > 0) wantedAt_ = now;
    if (!wantedAt_ || now - *wantedAt_ > idleAfter) return close();
    if (!player_ && !open(now)) return;
    if (const int fault = player_->show(levels, now); fault != 0) return fail(fault, now);
    failing_ = false;
}

bool ForceWriter::open(double now) noexcept {
    if (now < openAt_) return false;
    int fault = ENOMEM;
    try {
        port_ = open_(fault);
        if (port_) {
            player_ = std::make_unique<EffectPlayer>(*port_, abilities_);
            fault = player_->begin();
            if (fault == 0) return true;
        }
    } catch (const std::exception&) { // out of memory, or a folder that has gone: retried at the next attempt
        fault = ENOMEM;
    }
    fail(fault, now);
    return false;
}

/// A device that is gone is reported by the thread that reads it.
void ForceWriter::fail(int fault, double now) noexcept {
    close();
    openAt_ = now + searchEvery;
    const bool gone = fault == ENODEV || fault == ENOENT || fault == ENXIO;
    if (gone || std::exchange(failing_, true)) return;
    faults_.raise(fault == EACCES || fault == EPERM ? ForceFault::notAllowed : ForceFault::deaf);
}

void ForceWriter::close() noexcept {
    if (player_) player_->end();
    player_.reset();
    port_.reset();
}

} // namespace burin::input_events
