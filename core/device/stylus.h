// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/device/assist.h"
#include "core/device/axis_map.h"
#include "core/device/figure.h"
#include "core/geometry/pose.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace burin {

/// Number of translations and rotations, of the three each of rigid motion.
struct Freedoms {
    int translations = 0, rotations = 0; ///< 0 … 3 each
    friend bool operator==(const Freedoms&, const Freedoms&) = default;
};

/// What a stylus states about itself: its abilities, and the limits that every gain is scaled by. 0 means "not known"
/// (for limits of motors: none). Device frame.
struct StylusDescription {
    std::string name;
    Freedoms sensed{3, 3};
    Freedoms actuated;      ///< degrees of freedom driven by motors; rotations: it renders torque
    AssistAbilities assist; ///< of a device without such motors
    int buttons = 0;
    Figure<"Hz"> rate; ///< readings per second by its own clock; 0: a new reading whenever it is read
    Figure<"s"> delay; ///< from sampling the pose to rendering the resulting force, without the time of the tick itself
    Figure<"N"> maximumForce;
    Figure<"N"> continuousForce; ///< what its motors can render for minutes
    Figure<"N·mm"> maximumTorque;
    Figure<"N/m"> maximumStiffness; ///< closed loop at 1 kHz without delay
    Figure<"N·s/m"> maximumDamping;
    Figure<"N·mm/rad"> maximumTurningStiffness;
    Figure<"mm"> workspaceRadius;
    Figure<"mm"> positionStep; ///< resolution of its encoders
    Figure<"rad"> rotationStep;
    Figure<"mm/s"> maximumSpeed{1000.0, "Burin: no hand works faster on a desktop device"}; ///< faster is a fault
    Figure<"kg"> handleMass;    ///< mass felt by the hand with the motors off, where it is held
    bool carriesHandle = false; ///< the device lifts its handle by itself, by springs, weights or its own force
    bool simulated = false;     ///< no real hand is moved: forces are displayed, not felt

    bool hasMotors() const noexcept { return actuated.translations > 0 || actuated.rotations > 0; }
};

/// Checks whether a description can be used. Faults are: a value that is not finite, negative, or without a source;
/// more than 3 degrees of freedom; motors without force and stiffness; no name, workspace or speed.
/// Errors: argumentInvalid (place: which).
Result<void> checkDescription(const StylusDescription& description);

/// One reading. Device frame: x right, y away from the user, z up; mm.
struct StylusState {
    double time = 0.0; ///< s since the session began
    Pose pose;
    std::uint32_t buttons = 0; ///< bit 0: the first button
    bool valid = false;        ///< false: the device had no reading for this tick
    /// s since the previous reading, where only the stylus knows it (a recording); 0: the loop measures it
    double period = 0.0;
    double motorHeat = 0.0; ///< heat of the hottest motor as a share of its limit; 0: cool, or not measured
};

/// To be rendered by a device. Device frame, force and torque about the stylus' tip.
struct Wrench {
    glm::dvec3 force{0.0};  ///< N
    glm::dvec3 torque{0.0}; ///< N·mm; ignored by devices that can't render torque
    Assist assist{};        ///< for devices without motors that have AssistAbilities
};

/// State of a device, and statistics since it was opened.
struct DeviceHealth {
    bool connected = true;
    std::uint64_t readings = 0;  ///< arrived complete
    std::uint64_t lost = 0;      ///< numbered by the device, but never arrived
    std::uint64_t damaged = 0;   ///< failed their integrity check
    std::uint64_t repeated = 0;  ///< arrived twice or too late
    std::uint64_t overtaken = 0; ///< superseded by a newer reading before they were processed
    double roundTrip = 0.0; ///< s from sending the newest wrench to receiving its echo; 0: the device sends no echo
    std::optional<double> motorHeat;    ///< share of the limit of the motors, 0 … 1
    std::optional<double> batteryShare; ///< 0 … 1
    bool charging = false;
};

/// Interface that both kinds of stylus share. Functions are called on the owner's thread unless marked otherwise.
class StylusDevice {
public:
    virtual ~StylusDevice() = default;
    /// The description does not change, whether or not the stylus is open.
    virtual StylusDescription description() const = 0;
    /// May take seconds (a search, a handshake). Errors: those of the device.
    virtual Result<void> open() = 0;
    /// Switches the motors off. May be called when the stylus is not open, but not while another thread reads.
    virtual void close() noexcept = 0;
    /// The oldest fault that was not taken yet, as an error. A device that was unplugged reports this once, stays open,
    /// delivers invalid readings, and continues by itself when it is plugged in again.
    virtual std::optional<Error> takeFault() { return std::nullopt; }
    /// Any thread.
    virtual DeviceHealth health() const noexcept { return {}; }
    /// Any thread while the stylus is open, also when another thread is stuck in `read`, `write` or a tick: the motors
    /// are switched off at once, and come on again only with the answer to a reading made after this call. Does not
    /// wait for the other thread. Every stylus with motors has to override it; the default is for those without.
    virtual void cutMotors() noexcept {}

    /// The axes whose assignment to motions can be changed, at most AxisMap::mostAxes; empty: a device with a pose of
    /// its own. Does not change.
    virtual std::vector<DeviceAxis> axes() const { return {}; }
    /// The assignment without `assign`. Does not change.
    virtual AxisMap axisMap() const { return {}; }
    /// Another assignment, from the next reading on, whether or not the stylus is open. The thread that reads takes it
    /// over without a lock. @param map checked by checkAxisMap
    virtual void assign(const AxisMap& /*map*/) noexcept {}
    /// Any thread: the newest readings while the stylus is open, before any assignment.
    virtual AxisReading axisReading() const noexcept { return {}; }
};

/// A stylus that the loop calls at its own rate: one read and one write per tick.
class Stylus : public StylusDevice {
public:
    /// Called on one thread, between open and close. No allocation, lock, exception, log, or file access except to the
    /// device.
    /// @param time s since the session began.
    virtual StylusState read(double time) noexcept = 0;
    /// Called on the thread that reads. @param wrench already limited; the device renders it until the next one.
    virtual void write(const Wrench& wrench) noexcept = 0;
    /// Called on the thread that reads. True when the stylus has no more readings (the end of a trace, the last pass of
    /// a virtual operator).
    virtual bool finished() const noexcept { return false; }
};

/// The interface that a stylus with a clock of its own calls.
class StylusClient {
public:
    virtual ~StylusClient() = default;
    /// On the device's thread, before the first tick: scheduling, floating-point mode. May be slow.
    virtual void begins() noexcept {}
    /// On the device's thread, in time for its next force. No allocation, lock, exception, log or file access.
    /// @param state time: the device's own clock, s since `start`; not valid while the device is away or silent (then
    /// called about once a millisecond, so that the tick's own guards keep running).
    /// @return the wrench that the device renders until the next tick.
    virtual Wrench tick(const StylusState& state) noexcept = 0;
    /// On the device's thread, after each tick, once its answer was sent: for work that need not be done before the
    /// force. The same restrictions as for `tick`.
    virtual void answered() noexcept {}
    /// On the device's thread, after the last tick.
    virtual void ends() noexcept {}
};

/// A stylus whose own thread calls the client once for each of its readings and renders the answer at once: the only
/// delay between pose and force is the time of the tick.
class SelfPacedStylus : public StylusDevice {
public:
    /// Called once between open and close or stop. @param client outlives the ticks.
    virtual Result<void> start(StylusClient& client) = 0;
    /// When this returns, no tick runs any more and the motors are off. Must not be called from within a tick.
    virtual void stop() noexcept = 0;
};

} // namespace burin
