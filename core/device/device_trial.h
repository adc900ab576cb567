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

/// How a device did in a trial.
struct TrialFigures {
    double seconds = 0.0;
    std::uint64_t readings = 0; ///< that were valid
    std::uint64_t invalid = 0;
    double rate = 0.0;                ///< Hz, of all readings
    double usualPause = 0.0;          ///< s between two readings: as many were shorter as longer
    double longestPause = 0.0;        ///< s
    double largestTurn = 0.0;         ///< rad, from the first pose
    double finestStep = 0.0;          ///< mm, the least move from one reading to the next; 0: it stood
    glm::dvec3 least{0.0}, most{0.0}; ///< mm, of the places; device frame
    glm::dvec3 place{0.0};            ///< mm, the newest
    std::uint32_t buttons = 0;        ///< those that were pressed at some time, as bits
    double largestForce = 0.0;        ///< N that it was asked for
    DeviceHealth health;
    std::vector<Error> faults;
};

/// What a device is tried with.
struct TrialSettings {
    double seconds = 5.0; ///< > 0
    /// N, straight up, at most trialForceLimit; faded in over a second while the first button is held, gone when it is
    /// let go. 0: its motors stay off.
    double force = 0.0;
    /// What was measured so far, about ten times a second, on the thread that called; empty: nobody asks.
    std::function<void(const TrialFigures&)> told{};
};

/// N: the most that a trial asks of a device, a fifth of what its motors do, and what they bear for long, in whole 0.01
/// N. 0: it has none.
double trialForceLimit(const StylusDescription& stylus) noexcept;

/// Opens a device, reads it for a while, and closes it. Nothing of a job is needed. Thread: the owner's, which waits;
/// a stylus without a clock of its own is read there, 1000 times a second.
/// Errors: argumentInvalid (seconds, force), cancelled, those of StylusDevice::open and SelfPacedStylus::start.
Result<TrialFigures> tryDevice(const StylusHandle& stylus, const TrialSettings& settings, Progress& progress);

} // namespace burin
