// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/loop/servo_tick.h"

#include "core/haptics/haptic_step.h"
#include "core/haptics/loop/loop_clock.h"

#include <algorithm>

namespace burin {

ServoTick::ServoTick(HapticStep& step, TickSink& sink, double period, bool byTheClock) noexcept
    : step_(step), sink_(sink), limits_(gapLimits(period)), byTheClock_(byTheClock) {}

AtEdge ServoTick::edge() noexcept {
    const AtEdge answer = sink_.edge();
    if (answer == AtEdge::tick) return answer;
    // while the loop stands, the device gets no force
    withheld_ = withheld_ || (answer == AtEdge::stand && byTheClock_);
    sentBefore_ = 0;
    heart_.beat(now());
    return answer;
}

void ServoTick::begin() noexcept {
    begun_ = now();
    heart_.beat(begun_);
}

Wrench ServoTick::serve(const StylusState& reading, double period) noexcept {
    if (withheld_) step_.forceWithheld(); // between two ticks, like all changes of the step
    sample_ = step_.advance(reading, period);
    timing_.period = period;
    timing_.reading = reading;
    timing_.fault = faultOf(sample_, reading, period);
    const std::int64_t gap = byTheClock_ ? now() - (sentBefore_ > 0 ? sentBefore_ : begun_) : 0;
    withheld_ = gap > nanoseconds(limits_.late);
    if (!withheld_) return step_.deviceWrench();
    // If the step was told of the gap, it has given no force already. It does not know about its own slowness.
    ++timing_.late;
    sample_.flags |= sampleForcesOff | sampleForceLate;
    sample_.force = sample_.torque = glm::dvec3(0.0);
    return {};
}

/// Reports each fault once, when it begins.
TickFault ServoTick::faultOf(const Sample& sample, const StylusState& reading, double period) const noexcept {
    if ((sample.flags & sampleStylusInvalid) == 0 || faulty_) return TickFault::none;
    if (!reading.valid) return TickFault::device;
    const glm::dquat& q = reading.pose.rotation;
    if (!isFinite(reading.pose.position) || !isFinite(glm::dvec3(q.x, q.y, q.z)) || !isFinite(glm::dvec3(q.w)))
        return TickFault::damaged;
    return period > limits_.stalled ? TickFault::stalled : TickFault::tooFast;
}

void ServoTick::sent() noexcept {
    timing_.over = now();
    timing_.interval = sentBefore_ > 0 ? timing_.over - sentBefore_ : 0;
    if (timing_.interval > 0) histograms_.interval.add(timing_.interval);
    sentBefore_ = timing_.over;
    faulty_ = (sample_.flags & sampleStylusInvalid) != 0;
    ++ticks_;
    sink_.tick(sample_, timing_);
    timing_.work = now() - begun_;
    histograms_.work.add(timing_.work);
    // Without a device that could push, the motors need not be cut, however long it takes to find the device again.
    if (!timing_.reading.valid) heart_.rest();
}

void ServoTick::spent(std::int64_t nanoseconds) noexcept {
    timing_.cpu = nanoseconds;
    histograms_.cpu.add(nanoseconds);
}

} // namespace burin
