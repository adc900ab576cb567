// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/number_range.h"
#include "core/device/stylus.h"
#include "core/haptics/workspace_mapping.h"
#include "core/setup/axis_mode.h"

#include <cstdint>
#include <limits>

namespace burin {

/// How strongly cutting and sliding are felt. Chosen by whoever plans the session; nothing else reduces it.
struct FeltCutting {
    double gain = 1.0;      ///< 1: the hardest material's reference cut gives 0.6 of the maximum force
    double friction = 0.15; ///< Coulomb friction coefficient of the tool on surfaces that it slides on without cutting
    /// Ceiling of a device that only assists, as a share of its strongest effect, 0 … 1; 0: it shows nothing. Changes
    /// no sample, so that traces do not record it.
    double assist = 0.3;
};

/// Upper bounds of the gains of the coupling, in device space. They lower the gains that follow from the description of
/// the stylus, and never raise them.
struct GainLimits {
    static constexpr double none = std::numeric_limits<double>::infinity();
    static constexpr double softest = 1.0; ///< N/m: a stiffness below it could not be felt
    double stiffness = none;               ///< N/m, >= softest
    double damping = none;                 ///< N·s/m, >= 0
    friend bool operator==(const GainLimits&, const GainLimits&) = default;
};

/// Keeps shank and holder at a distance from the stock that is left, so that they push the hand back before they touch
/// it, as part and fixtures do (StockBoundary). The distance is kept from the centre lines of the stock's voxels: their
/// sides are nearer by half a voxel, their edges along the runs by 0.71.
struct StockLayer {
    static constexpr NumberRange distances{0.1, 10.0}; ///< mm
    static constexpr double usualDistance = 1.0;       ///< mm
    double distance = 0.0; ///< mm; 0: there is no such layer, and touching the stock stops shank and holder
    bool on = false;       ///< initially
};

/// Gains and limits of one session.
struct HapticSettings {
    WorkspaceMapping mapping;
    StylusDescription stylus;     ///< its limits apply to everything that is sent
    AxisMode axis;                ///< has to fit the boundary of the tool
    double allowance = 0.0;       ///< mm left on the part
    double cuttingSpeed = 1000.0; ///< mm/s of the cutting edge
    FeltCutting felt;
    StockLayer stock;
    GainLimits gains;                        ///< measured on this device, or chosen by its user
    static constexpr double safeShare = 0.8; ///< of the stiffness that theory allows for a handle that nobody holds
    double couplingShare = safeShare;        ///< of the stylus' maximum stiffness
    double guideShare = 0.6;                 ///< of the stylus' maximum stiffness, for the springs of the guides
    double forceShare = 0.6;                 ///< of the stylus' maximum force
    double rampSeconds = 1.5;                ///< forces fade in after start and after any fault
    double tickPeriod = 0.001;               ///< s, intended by the loop; later ticks count as late
    bool cutsOnButton = false;               ///< the spindle turns only while the stylus' first button is down
    /// dead man's switch: forces only while one of these buttons is held, as a bit mask; 0: always
    std::uint32_t forceButtons = 0;

    /// Largest force that is ever sent, N; 0 for a stylus without motors.
    double maximumForce() const noexcept { return stylus.hasMotors() ? forceShare * stylus.maximumForce.value : 0.0; }
};

} // namespace burin
