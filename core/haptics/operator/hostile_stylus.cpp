// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/operator/hostile_stylus.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace burin {
namespace {

constexpr double jumpLength = 50.0;   // mm
constexpr double buttonShare = 0.002; // of the ticks in which a button is pressed or released
constexpr double longestStep = 0.02;  // s of hand motion in one tick, however long the tick was
constexpr int fewestCalmTicks = 4;
constexpr double slamShare = 0.3, restShare = 0.1;
constexpr std::uint64_t readingEvents = 6, allEvents = 9;

} // namespace

HostileStylus::HostileStylus(const HostileSettings& settings)
    : settings_(settings)
    , random_(settings.seed)
    , tremor_(settings.tremor, settings.seed)
    , arm_(settings.hand, settings.handle, HandReaction{}) {
    static_cast<void>(open());
}

Result<void> HostileStylus::open() {
    random_ = SeededRandom(settings_.seed);
    arm_.reset();
    // Above the region in which it moves, so that it starts clear of the part.
    intended_ = settings_.region.centre();
    intended_.z = settings_.region.high.z;
    target_ = intended_;
    speed_ = resting_ = time_ = 0.0;
    force_ = glm::dvec3(0.0);
    buttons_ = 0;
    calmTicks_ = 0;
    aside_ = false;
    return {};
}

void HostileStylus::chooseStroke() noexcept {
    const double kind = random_.share();
    if (kind < restShare) {
        resting_ = random_.between(0.05, 0.5);
        return;
    }
    target_ = random_.within(settings_.region.low, settings_.region.high);
    speed_ = kind < restShare + slamShare ? random_.between(300.0, 900.0) : random_.between(5.0, 120.0);
}

void HostileStylus::move(double seconds) noexcept {
    const double step = std::clamp(seconds, 0.0, longestStep);
    arm_.advance(force_, std::max(step, 1e-6));
    if (resting_ > 0.0) {
        resting_ -= step;
        return;
    }
    const glm::dvec3 rest = target_ - intended_;
    if (glm::length(rest) <= speed_ * step || speed_ == 0.0) {
        if (speed_ > 0.0) intended_ = target_;
        return chooseStroke();
    }
    intended_ += glm::normalize(rest) * speed_ * step;
}

HostileEvent HostileStylus::drawEvent(bool withPeriods) noexcept {
    if (aside_) return HostileEvent::jump; // the tick that comes back
    // After an invalid reading even a jump is a new start: so only one event at a time.
    if (++calmTicks_ < fewestCalmTicks || random_.share() >= settings_.eventShare) return HostileEvent::none;
    calmTicks_ = 0;
    return static_cast<HostileEvent>(1 + random_.below(withPeriods ? allEvents : readingEvents));
}

double HostileStylus::drawPeriod(HostileEvent event) noexcept {
    const double period = settings_.period;
    switch (event) {
    case HostileEvent::late:
        return period * random_.between(4.0, 9.0);
    case HostileEvent::stalled:
        return period * random_.between(11.0, 300.0);
    case HostileEvent::badPeriod: {
        const std::array<double, 3> bad{-period, 0.0, std::numeric_limits<double>::quiet_NaN()};
        return bad[random_.below(bad.size())];
    }
    default:
        return period * (1.0 + settings_.jitter * random_.between(-1.0, 1.0));
    }
}

StylusState HostileStylus::reading(HostileEvent event) noexcept {
    if (random_.share() < buttonShare) buttons_ ^= 1U << random_.below(3);
    StylusState state;
    state.time = time_;
    state.buttons = buttons_;
    state.valid = event != HostileEvent::dropped;
    const glm::dvec3 place = intended_ + arm_.deviation() + tremor_.at(time_);
    const double step = settings_.encoderStep;
    state.pose.position = step > 0.0 ? glm::round(place / step) * step : place;
    const auto axis = static_cast<glm::length_t>(random_.below(3));
    switch (event) {
    case HostileEvent::notANumber:
        state.pose.position[axis] = std::numeric_limits<double>::quiet_NaN();
        break;
    case HostileEvent::infinite:
        state.pose.position[axis] = std::copysign(std::numeric_limits<double>::infinity(), random_.share() - 0.5);
        break;
    case HostileEvent::huge:
        state.pose.position[axis] = 1e300;
        break;
    case HostileEvent::badTurn:
        state.pose.rotation.w = std::numeric_limits<double>::quiet_NaN();
        break;
    case HostileEvent::jump:
        if (!aside_) state.pose.position += jumpLength * random_.direction();
        break;
    default:
        break;
    }
    aside_ = event == HostileEvent::jump && !aside_;
    return state;
}

HostileStylus::Tick HostileStylus::next() noexcept {
    Tick tick;
    tick.event = drawEvent(true);
    tick.period = drawPeriod(tick.event);
    const double passed = tick.period > 0.0 ? tick.period : settings_.period;
    time_ += passed;
    move(passed);
    tick.state = reading(tick.event);
    return tick;
}

StylusState HostileStylus::read(double time) noexcept {
    const double passed = std::max(0.0, time - time_);
    time_ = time;
    move(passed);
    return reading(drawEvent(false));
}

void HostileStylus::write(const Wrench& wrench) noexcept {
    const double most = settings_.stylus.maximumForce.value;
    force_ = isFinite(wrench.force) ? clampLength(wrench.force, most) : glm::dvec3(0.0);
}

} // namespace burin
