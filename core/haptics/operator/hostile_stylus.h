// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/seeded_random.h"
#include "core/device/stylus.h"
#include "core/geometry/box.h"
#include "core/haptics/operator/operator_hand.h"

namespace burin {

/// What is wrong with a tick.
enum class HostileEvent : std::uint8_t {
    none,
    notANumber, ///< a coordinate of the place
    infinite,   ///< a coordinate of the place
    huge,       ///< a place of 1e300 mm
    badTurn,    ///< a rotation that is none
    dropped,    ///< no valid reading
    jump,       ///< 50 mm aside, for one tick; the tick that comes back is one, too
    late,       ///< 4 to 9 periods
    stalled,    ///< 11 to 300 periods
    badPeriod,  ///< a period that is negative, zero or not a number
};

/// How hostile. Shares are of the ticks.
struct HostileSettings {
    StylusDescription stylus;
    Box region; ///< mm, device frame, that the hand strays in; partly inside the part, so that it collides
    HandImpedance hand = middleHand;
    HandleInertia handle;
    double period = 0.001; ///< s, nominal
    double eventShare = 0.01;
    double jitter = 0.3;       ///< of the period, to either side, evenly
    double tremor = 0.3;       ///< mm rms along each axis, 8 to 12 Hz: several times a hand's
    double encoderStep = 0.02; ///< mm
    std::uint64_t seed = 1;
};

/// A stylus that does everything a driver, a cable or a child can do to a loop: slams of 300 to 900 mm/s into whatever
/// is there, rest, calm strokes, tremor, jitter, buttons at random, and readings and periods that make no sense. A hand
/// holds it, which the force pushes about. The same seed and forces give the same ticks, bit by bit. To use it:
///
///     HostileStylus hostile({.stylus = description, .region = region, .seed = 1});
///     for (...) {
///         const HostileStylus::Tick tick = hostile.next();
///         const Sample sample = step.advance(tick.state, tick.period);
///         hostile.write(step.deviceWrench());
///         // demand: a finite force within its limits; no force at all where HostileStylus::mustBeStill(tick.event)
///     }
///
/// As a Stylus, in a servo loop that has periods of its own, it gives the same readings without the bad periods.
class HostileStylus final : public Stylus {
public:
    struct Tick {
        StylusState state;
        double period = 0.0; ///< s since the tick before, as the step shall be told
        HostileEvent event = HostileEvent::none;
    };

    explicit HostileStylus(const HostileSettings& settings);

    Tick next() noexcept;
    /// No force may follow from a tick with this event, in the same tick.
    static bool mustBeStill(HostileEvent event) noexcept { return event != HostileEvent::none; }

    StylusDescription description() const override { return settings_.stylus; }
    Result<void> open() override;
    StylusState read(double time) noexcept override;
    /// Held until the next tick.
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
    double resting_ = 0.0;                   ///< s of rest that are left
    glm::dvec3 force_{0.0};                  ///< N
    double time_ = 0.0;                      ///< s
    std::uint32_t buttons_ = 0;
    int calmTicks_ = 0;  ///< since the last event
    bool aside_ = false; ///< the last reading was 50 mm off
};

} // namespace burin
