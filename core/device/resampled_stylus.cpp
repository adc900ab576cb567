// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/device/resampled_stylus.h"

namespace burin {

StylusDescription ResampledStylus::description() const {
    StylusDescription description = stylus_->description();
    if (description.rate.value > 0.0) {
        description.delay.value += 1.0 / description.rate.value;
        description.delay.source += description.delay.source.empty() ? "" : "; ";
        description.delay.source += "one period of the device for two clocks that are not bound together";
    }
    return description;
}

Result<void> ResampledStylus::open() {
    newest_ = {};
    wrench_ = {};
    freshAt_ = wantedAt_ = 0.0;
    states_.take(newest_); // of an earlier session
    wrenches_.take(wrench_);
    newest_.valid = false;
    wrench_ = {};
    cut_ = false;
    if (Result<void> opened = stylus_->open(); !opened) return opened;
    return stylus_->start(*this);
}

void ResampledStylus::close() noexcept {
    stylus_->stop();
    stylus_->close();
}

StylusState ResampledStylus::read(double time) noexcept {
    if (states_.take(newest_)) freshAt_ = time;
    newest_.time = time;
    if (time - freshAt_ > longestSilence) newest_.valid = false;
    return newest_;
}

void ResampledStylus::cutMotors() noexcept {
    cut_.store(true, std::memory_order_release);
    stylus_->cutMotors();
}

Wrench ResampledStylus::tick(const StylusState& state) noexcept {
    states_.post(state);
    if (wrenches_.take(wrench_)) wantedAt_ = state.time;
    if (cut_.exchange(false, std::memory_order_acquire)) wrench_ = {};
    return state.time - wantedAt_ > longestWait ? Wrench{} : wrench_;
}

std::unique_ptr<Stylus> calledByLoop(AnyStylus stylus) {
    if (auto* called = std::get_if<std::unique_ptr<Stylus>>(&stylus)) return std::move(*called);
    return std::make_unique<ResampledStylus>(std::move(std::get<std::unique_ptr<SelfPacedStylus>>(stylus)));
}

} // namespace burin
