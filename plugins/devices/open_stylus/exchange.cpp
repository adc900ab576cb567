// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/open_stylus/exchange.h"

#include <algorithm>
#include <utility>

namespace burin::openstylus {
namespace {

constexpr double perMicrosecond = 1e-6;
constexpr double longestStep = 0.1; // s between two readings; a longer step of the device's clock is not used
constexpr double longestRoundTrip = 0.2;

constexpr std::array<std::pair<ReportedFault, DeviceFault>, 7> reportedFaults{
    {{reportedWatchdog, DeviceFault::watchdog},
     {reportedNotCalibrated, DeviceFault::notCalibrated},
     {reportedOverheated, DeviceFault::overheated},
     {reportedOverloaded, DeviceFault::overloaded},
     {reportedTooFast, DeviceFault::tooFast},
     {reportedStopped, DeviceFault::stopped},
     {reportedMechanism, DeviceFault::mechanism}}};

glm::dvec3 limited(const glm::dvec3& wanted, double maximum) noexcept {
    constexpr double step = 0x1.0p-16; // added by rounding at most
    return isFinite(wanted) ? clampLength(wanted, std::max(0.0, maximum - step)) : glm::dvec3(0.0);
}

} // namespace

Exchange::Exchange(const Identity& identity) noexcept : identity_(identity) {}

void Exchange::restart() noexcept {
    known_ = clockHeld_ = motorsOn_ = false;
    arming_ = armingReports;
    damagedRun_ = backwardsRun_ = 0;
    faultsBefore_ = 0;
}

Exchange::Outcome Exchange::take(Bytes report, double now) noexcept {
    const std::optional<Reading> reading = decodeInput(report);
    if (!reading) {
        damaged_.fetch_add(1, std::memory_order_relaxed);
        if (++damagedRun_ == damagedInARow) faults_.raise(DeviceFault::damaged);
        return Outcome::damaged;
    }
    damagedRun_ = 0;
    if (!number(*reading)) {
        repeated_.fetch_add(1, std::memory_order_relaxed);
        return Outcome::old;
    }
    readings_.fetch_add(1, std::memory_order_relaxed);
    advanceTime(*reading, now);
    hearEcho(*reading, now);
    tellFaults(*reading);
    motorsOn_ = reading->motorsOn;
    if (reading->faults != 0) arming_ = armingReports;
    motorHeat_.store(reading->motorHeat.value_or(-1.0), std::memory_order_relaxed);
    state_.motorHeat = reading->motorHeat.value_or(0.0);
    const bool pushes = identity_.actuated.translations > 0 || identity_.actuated.rotations > 0;
    state_.pose.position = reading->pose.position;
    state_.pose.rotation = glm::normalize(reading->pose.rotation);
    state_.buttons = reading->buttons;
    // If motors are reported as on while the host has them off, the device has not received that yet, or its report is
    // wrong: no force would be rendered.
    const bool driven = motorsOn_ && arming_ == 0;
    state_.valid = reading->poseValid && reading->faults == 0 && (driven || !pushes);
    known_ = true;
    return Outcome::reading;
}

/// Returns false for a report that was received before. Numbers ahead by less than half of the range count as newer.
bool Exchange::number(const Reading& reading) noexcept {
    const auto ahead = static_cast<std::uint16_t>(reading.sequence - sequence_);
    if (known_ && ahead == 0) return false;
    if (known_ && ahead >= 0x8000U) {
        if (++backwardsRun_ < backwardsInARow) return false;
        restart();
    }
    backwardsRun_ = 0;
    if (known_) lost_.fetch_add(ahead - 1U, std::memory_order_relaxed);
    sequence_ = reading.sequence;
    return true;
}

/// Uses the device's clock, which is not affected by delays of the bus; after a gap the host's clock.
void Exchange::advanceTime(const Reading& reading, double now) noexcept {
    const double stepped = static_cast<double>(reading.microseconds - microseconds_) * perMicrosecond;
    const bool believed = clockHeld_ && stepped > 0.0 && stepped <= longestStep;
    const double elapsed = std::max(now - lastTaken_, perMicrosecond);
    state_.time += believed ? stepped : (lastTaken_ > 0.0 ? std::min(elapsed, longestStep) : perMicrosecond);
    microseconds_ = reading.microseconds;
    lastTaken_ = now;
    clockHeld_ = true;
}

void Exchange::hearEcho(const Reading& reading, double now) noexcept {
    if (!known_) {
        lastEcho_ = now;
        echo_ = reading.echo;
        deafTold_ = false;
    } else if (reading.heard && reading.echo != echo_) {
        echo_ = reading.echo;
        lastEcho_ = now;
        deafTold_ = false;
        const double roundTrip = now - sentAt_[echo_ & 0xffU];
        const auto age = static_cast<std::uint16_t>(sent_.load(std::memory_order_relaxed) - echo_);
        if (age < sentAt_.size() && roundTrip >= 0.0 && roundTrip < longestRoundTrip)
            roundTrip_.store(roundTrip, std::memory_order_relaxed);
    } else if (!deafTold_ && now - lastEcho_ > deafSeconds) {
        deafTold_ = true;
        faults_.raise(DeviceFault::deaf);
    }
}

void Exchange::tellFaults(const Reading& reading) noexcept {
    const unsigned risen = reading.faults & ~static_cast<unsigned>(faultsBefore_);
    for (const auto& [reported, fault] : reportedFaults)
        if ((risen & reported) != 0) faults_.raise(fault);
    faultsBefore_ = reading.faults;
}

const StylusState& Exchange::silence(double elapsed) noexcept {
    state_.time += std::max(elapsed, perMicrosecond);
    state_.valid = false;
    lastTaken_ += elapsed;
    clockHeld_ = false;
    return state_;
}

std::array<std::uint8_t, outputSize> Exchange::answer(const Wrench& wrench, double now) noexcept {
    if (cut_.exchange(false, std::memory_order_acquire)) {
        arming_ = armingReports;
        motorsOn_ = false;
    }
    if (faultsBefore_ != 0 || arming_ > 0) {
        if (faultsBefore_ == 0) --arming_;
        return send({}, false, now);
    }
    return send(motorsOn_ ? wrench : Wrench{}, true, now);
}

std::array<std::uint8_t, outputSize> Exchange::farewell(double now) noexcept {
    arming_ = armingReports;
    return send({}, false, now);
}

std::array<std::uint8_t, outputSize> Exchange::emergency(int attempt) const noexcept {
    constexpr unsigned far = 0x8000; // half of the range away from the numbers in use
    Command command;
    command.sequence = static_cast<std::uint16_t>(sent_.load(std::memory_order_relaxed) + far + unsigned(attempt));
    return encodeOutput(command);
}

std::array<std::uint8_t, outputSize> Exchange::send(const Wrench& wrench, bool motors, double now) noexcept {
    Command command;
    command.sequence = static_cast<std::uint16_t>(sent_.load(std::memory_order_relaxed) + 1U);
    sent_.store(command.sequence, std::memory_order_relaxed);
    command.echo = sequence_;
    command.motors = motors;
    command.wrench.force = limited(wrench.force, identity_.maximumForce);
    command.wrench.torque = limited(wrench.torque, identity_.maximumTorque);
    sentAt_[command.sequence & 0xffU] = now;
    return encodeOutput(command);
}

DeviceHealth Exchange::health() const noexcept {
    DeviceHealth health;
    health.readings = readings_.load(std::memory_order_relaxed);
    health.lost = lost_.load(std::memory_order_relaxed);
    health.damaged = damaged_.load(std::memory_order_relaxed);
    health.repeated = repeated_.load(std::memory_order_relaxed);
    health.overtaken = overtaken_.load(std::memory_order_relaxed);
    health.roundTrip = roundTrip_.load(std::memory_order_relaxed);
    if (const double heat = motorHeat_.load(std::memory_order_relaxed); heat >= 0.0) health.motorHeat = heat;
    return health;
}

} // namespace burin::openstylus
