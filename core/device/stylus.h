// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/device/figure.h"
#include "core/geometry/pose.h"

#include <cstdint>
#include <optional>
#include <string>

namespace burin {

/// How many of the three translations and the three rotations of space.
struct Freedoms {
    int translations = 0, rotations = 0; ///< 0 … 3 each
    friend bool operator==(const Freedoms&, const Freedoms&) = default;
};

/// What a stylus says of itself: what it can do, and the limits that every gain is scaled by. 0 is "not known" (for
/// limits of motors: none). Device frame.
struct StylusDescription {
    std::string name;
    Freedoms sensed{3, 3};
    Freedoms actuated; ///< that its motors push; rotations: it renders torque
    int buttons = 0;
    Figure<"Hz"> rate; ///< its own readings a second; 0: a new one whenever it is asked
    Figure<"s"> delay; ///< from the sampled pose to the force it leads to, beyond the tick between them
    Figure<"N"> maximumForce;
    Figure<"N"> continuousForce; ///< that its motors bear for minutes
    Figure<"N·mm"> maximumTorque;
    Figure<"N/m"> maximumStiffness; ///< closed loop at 1 kHz without delay
    Figure<"N·s/m"> maximumDamping;
    Figure<"N·mm/rad"> maximumTurningStiffness;
    Figure<"mm"> workspaceRadius;
    Figure<"mm"> positionStep; ///< what its encoders resolve
    Figure<"rad"> rotationStep;
    Figure<"mm/s"> maximumSpeed{1000.0, "Burin: no hand works faster on a desktop device"}; ///< faster is a fault
    Figure<"kg"> handleMass;    ///< that hangs on the hand with the motors off, where it is held
    bool carriesHandle = false; ///< the device lifts its handle by itself, by springs, weights or its own force
    bool simulated = false;     ///< nobody's hand is moved: what is written is shown, not felt

    bool hasMotors() const noexcept { return actuated.translations > 0 || actuated.rotations > 0; }
};

/// What keeps a description from being used: a figure that is not finite, negative, or without its source; freedoms
/// beyond 3; motors without force and stiffness; no name, workspace or speed. Errors: argumentInvalid (place: which).
Result<void> checkDescription(const StylusDescription& description);

/// One reading. Device frame: x right, y away from the user, z up; mm.
struct StylusState {
    double time = 0.0; ///< s since the session began
    Pose pose;
    std::uint32_t buttons = 0; ///< bit 0: the first button
    bool valid = false;        ///< false: the device had nothing to say this tick
    double period = 0.0;    ///< s since the reading before, where only the stylus knows: a recording; 0: the loop does
    double motorHeat = 0.0; ///< of the hottest motor, share of what it bears; 0: cool, or not measured
};

/// What a device shall render. Device frame, about the stylus' tip.
struct Wrench {
    glm::dvec3 force{0.0};  ///< N
    glm::dvec3 torque{0.0}; ///< N·mm; left out by devices without it
};

/// How a device has been doing since it was opened.
struct DeviceHealth {
    bool connected = true;
    std::uint64_t readings = 0;      ///< that arrived whole
    std::uint64_t lost = 0;          ///< that the device numbered but that never came
    std::uint64_t damaged = 0;       ///< that failed their check
    std::uint64_t repeated = 0;      ///< that had come before, or came too late
    std::uint64_t overtaken = 0;     ///< that a newer one had followed before they were looked at
    double roundTrip = 0.0;          ///< s from the newest wrench that was sent to its echo; 0: the device echoes none
    std::optional<double> motorHeat; ///< share of what the motors bear, 0 … 1
    std::optional<double> batteryShare; ///< 0 … 1
    bool charging = false;
};

/// What both kinds of stylus have in common. The owner's thread calls everything that is not marked otherwise.
class StylusDevice {
public:
    virtual ~StylusDevice() = default;
    /// The same before, while and after it is open.
    virtual StylusDescription description() const = 0;
    /// May take seconds (a search, a handshake). Errors: those of the device.
    virtual Result<void> open() = 0;
    /// Motors off. Also when it is not open. Not while another thread reads.
    virtual void close() noexcept = 0;
    /// The oldest fault that nobody took yet, as a message. A device that was unplugged says so once, stays open, gives
    /// readings that are not valid, and goes on by itself when it is plugged in again.
    virtual std::optional<Error> takeFault() { return std::nullopt; }
    /// Any thread.
    virtual DeviceHealth health() const noexcept { return {}; }
    /// Any thread while the stylus is open, also when another one is stuck in `read`, `write` or a tick: the motors go
    /// off at once, and come on again only for what is read and answered after it. Does not wait for that other thread.
    /// Every stylus with motors has its own; the default is for those without.
    virtual void cutMotors() noexcept {}
};

/// A stylus that the loop calls, at the loop's own edges: one read and one write a tick.
class Stylus : public StylusDevice {
public:
    /// One thread, between open and close. No allocation, lock, exception, log, file but the device.
    /// @param time s since the session began.
    virtual StylusState read(double time) noexcept = 0;
    /// The thread that reads. @param wrench already limited; the device holds it until the next one.
    virtual void write(const Wrench& wrench) noexcept = 0;
    /// The thread that reads. True when the stylus has nothing more to say (a trace's end, a virtual operator's last
    /// pass).
    virtual bool finished() const noexcept { return false; }
};

/// What a stylus with a clock of its own calls.
class StylusClient {
public:
    virtual ~StylusClient() = default;
    /// On the device's thread, before the first tick: scheduling, floating-point mode. May take its time.
    virtual void begins() noexcept {}
    /// On the device's thread, in time for its next force. No allocation, lock, exception, log, file.
    /// @param state time: the device's own clock, s since `start`; not valid while the device is away or silent (then
    /// about once a millisecond, so that the tick's own guards keep running).
    /// @return what the device renders until the next tick.
    virtual Wrench tick(const StylusState& state) noexcept = 0;
    /// On the device's thread, after each tick, once its answer is on its way: for what need not come before the force.
    /// The same rule as for `tick`.
    virtual void answered() noexcept {}
    /// On the device's thread, after the last tick.
    virtual void ends() noexcept {}
};

/// A stylus whose own thread calls us, once for each of its readings, and renders the answer at once: no time passes
/// between pose and force but that of the tick.
class SelfPacedStylus : public StylusDevice {
public:
    /// Once between open and close or stop. @param client outlives the ticks.
    virtual Result<void> start(StylusClient& client) = 0;
    /// No tick runs any more when this returns, and the motors are off. Not from within a tick.
    virtual void stop() noexcept = 0;
};

} // namespace burin
