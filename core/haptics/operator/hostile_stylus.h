// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/seeded_random.h"
#include "core/device/stylus.h"
#include "core/geometry/box.h"
#include "core/haptics/operator/operator_hand.h"

namespace burin {

/// The disturbance in a tick.
enum class HostileEvent : std::uint8_t {
    none,
    notANumber, ///< a coordinate of the position is NaN
    infinite,   ///< a coordinate of the position is infinite
    huge,       ///< a position of 1e300 mm
    badTurn,    ///< an invalid rotation
    dropped,    ///< no valid reading
    jump,       ///< 50 mm aside, for one tick; the tick that comes back is a jump, too
    late,       ///< 4 to 9 periods
    stalled,    ///< 11 to 300 periods
    badPeriod,  ///< a period that is negative, zero or not a number
};

/// Settings of the disturbances. Shares are of the ticks.
struct HostileSettings {
    StylusDescription stylus;
    Box region; ///< mm, device frame, in which the hand moves; partly inside the part, so that it collides
    HandImpedance hand = middleHand;
    HandleInertia handle;
    double period = 0.001; ///< s, nominal
    double eventShare = 0.01;
    double jitter = 0.3;       ///< share of the period, to either side, uniformly distributed
    double tremor = 0.3;       ///< mm rms along each axis, 8 to 12 Hz: several times a hand's
    double encoderStep = 0.02; ///< mm
    std::uint64_t seed = 1;
};

/// A stylus that subjects a loop to everything that a driver, a cable or a child can do: slams of 300 to 900 mm/s into
/// obstacles, rest, calm strokes, tremor, jitter, random buttons, and invalid readings and periods. It is held by a
/// simulated hand, which the force moves. The same seed and forces give the same ticks, bit by bit. To use it:
///
///     HostileStylus hostile({.stylus = description, .region = region, .seed = 1});
///     for (...) {
///         const HostileStylus::Tick tick = hostile.next();
///         const Sample sample = step.advance(tick.state, tick.period);
///         hostile.write(step.deviceWrench());
///         // demand: a finite force within its limits; no force at all where HostileStylus::mustBeStill(tick.event)
///     }
///
/// As a Stylus in a servo loop, which has periods of its own, it gives the same readings without the invalid periods.
class HostileStylus final : public Stylus {
public:
    struct Tick {
        StylusState state;
        double period = 0.0; ///< s since the last tick, to be passed to the step
        HostileEvent event = HostileEvent::none;
    };

    explicit HostileStylus(const HostileSettings& settings);

    Tick next() noexcept;
    /// Whether a tick with this event must not lead to a force in the same tick.
    static bool mustBeStill(HostileEvent event) noexcept { return event != HostileEvent::none; }

    StylusDescription description() const override { return settings_.stylus; }
    Result<void> open() override;
    StylusState read(double time) noexcept override;
    /// Renders the wrench until the next tick.
    void write(const Wrench& wrench) noexcept override;
    void close() noexcept override { force_ = glm::dvec3(0.0); }

private:
    HostileEvent drawEvent(bool withPeriods) noexcept;
    double drawPeriod(HostileEvent event) noexcept;
    void move(double seconds) noexcept;
    void chooseStroke() noexcept;
    StylusState reading(HostileEvent event) noexcept;

    HostileSettings settings_;
    SeededRandom random_;
    Tremor tremor_;
    HandArm arm_;
    glm::dvec3 intended_{0.0}, target_{0.0}; ///< mm, device frame
    double speed_ = 0.0;                     ///< mm/s, of the stroke
    double resting_ = 0.0;                   ///< s, remaining time of rest
    glm::dvec3 force_{0.0};                  ///< N
    double time_ = 0.0;                      ///< s
    std::uint32_t buttons_ = 0;
    int calmTicks_ = 0;  ///< number of ticks since the last event
    bool aside_ = false; ///< whether the last reading was 50 mm aside
};

} // namespace burin
