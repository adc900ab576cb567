// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/device/stylus_handle.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace burin {

/// Measurements of a trial.
struct TrialFigures {
    double seconds = 0.0;
    std::uint64_t readings = 0; ///< valid readings
    std::uint64_t invalid = 0;
    double rate = 0.0;            ///< Hz, of all readings
    double medianInterval = 0.0;  ///< s, between two readings
    double usualInterval = 0.0;   ///< s, between two readings: 99 of 100 are shorter
    double maximumInterval = 0.0; ///< s, between two readings
    /// s, from a reading to its force, by the device's echoes (DeviceHealth::roundTrip): of those that were looked at,
    /// ten a second, nine of ten were shorter. 0: it sends none
    double latency = 0.0;
    double maximumRotation = 0.0;         ///< rad, from the first pose
    double smallestStep = 0.0;            ///< mm, between two consecutive readings; 0: the stylus did not move
    glm::dvec3 lowest{0.0}, highest{0.0}; ///< mm, of each coordinate; device frame
    glm::dvec3 position{0.0};             ///< mm, the newest
    std::uint32_t buttons = 0;            ///< bit mask of all buttons that were pressed during the trial
    double maximumForce = 0.0;            ///< N, commanded
    double maximumAssist = 0.0;           ///< commanded, share of the strongest effect of a device that only assists
    DeviceHealth health;
    std::vector<Error> faults;
};

/// Duration and force of a trial.
struct TrialSettings {
    double seconds = 5.0; ///< > 0
    /// N, straight up, at most trialForceLimit; fades in over a second while the first button is held, and is 0 as soon
    /// as it is released. 0: the motors stay off.
    double force = 0.0;
    /// For a device with AssistAbilities: share of its strongest effect, 0 … 1. While the first button is held, the
    /// strength rises from 0 to this within each second (trialAssist); 0: it shows nothing.
    double assist = 0.0;
    /// Called with the measurements so far, about ten times a second, on the caller's thread. May be empty.
    std::function<void(const TrialFigures&)> report{};
};

/// The effect of a trial at a time: a stick pushes to the right, away, to the left and towards the user, for a second
/// each; the strong and the weak motor of a vibration take turns.
/// @param seconds since the button was pressed. @param ceiling share of the strongest effect, 0 … 1
Assist trialAssist(double seconds, double ceiling) noexcept;

/// Largest force of a trial, N: a fifth of the maximum force, at most the continuous one, rounded down to 0.01 N. 0:
/// the device has no motors.
double trialForceLimit(const StylusDescription& stylus) noexcept;

/// Opens a device, reads it for the time requested, and closes it; needs no project. Called on the owner's thread,
/// which it blocks. A stylus without a clock of its own is read 1000 times a second, on a thread that this function
/// starts. Errors: argumentInvalid (seconds, force, assist), cancelled, those of StylusDevice::open and
/// SelfPacedStylus::start.
Result<TrialFigures> tryDevice(const StylusHandle& stylus, const TrialSettings& settings, Progress& progress);

} // namespace burin
