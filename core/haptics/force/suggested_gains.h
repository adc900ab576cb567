// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/device_trial.h"
#include "core/haptics/haptic_settings.h"

#include <optional>

namespace burin {

/// What a user states about the gains of a device.
struct GainRequest {
    static constexpr double mostFriction = 10.0; ///< N
    double ceiling = GainLimits::none;           ///< N/m, >= GainLimits::softest: never a stiffness above it
    /// N, Coulomb friction of the handle with the motors off, as a spring balance shows it while the handle just moves;
    /// 0: not known
    double friction = 0.0;
};

/// What sets the suggested stiffness.
enum class GainBound : std::uint8_t {
    device,   ///< the stiffness that the device states
    rate,     ///< a force is held for as long as a reading lasts
    jitter,   ///< some readings come later than the others
    latency,  ///< of the force behind its reading
    encoders, ///< steps of the position, that friction has to absorb
    ceiling   ///< of the user
};

/// Gains for the spring at the boundary, and the measurements that they follow from. Device space.
struct SuggestedGains {
    double stiffness = 0.0; ///< N/m
    double damping = 0.0;   ///< N·s/m
    GainBound bound = GainBound::device;
    double hold = 0.0;            ///< s that a force is held for: 99 of 100 intervals between readings are shorter
    double jitter = 0.0;          ///< s, of that more than the median interval
    double latency = 0.0;         ///< s, from a reading to its force; an upper bound
    bool latencyMeasured = false; ///< by an echo of the device; false: as the device states it, 0 if it does not
    double step = 0.0;            ///< mm, of the encoders; 0: not known
    double friction = 0.0;        ///< N, as requested

    GainLimits limits() const noexcept { return {stiffness, damping}; }
};

/// The share of the theoretical limits that a suggested stiffness leaves unused.
inline constexpr double gainMargin = 1.0 - HapticSettings::safeShare;

/// Gains for a device as it was measured in a trial, for a handle that nobody holds, the worst case.
///
/// A spring K that is held for T and acts after a latency d takes K (T/2 + d) from the damping b of the handle, and is
/// passive below b (Colgate & Schenkel 1994: b > K T/2 + |B|; with a latency Gil, Hulin and others 2004). b is that of
/// the device's stated stiffness, which holds for T = 1 ms without latency: K T/2. Friction f absorbs steps q of the
/// encoders while K <= 2 f / q (Abbott & Okamura 2005; Diolaiti and others 2006). The damper's |B| is not subtracted:
/// its energy is watched by the PassivityController, and it is kept slow enough for the handle's mass instead
/// (usableDamping).
///
/// Never above what couplingGains permits without a measurement, nor above the user's ceiling. Empty if the device has
/// no motors, or the trial had too few readings (200) for its intervals to be known.
std::optional<SuggestedGains> suggestGains(const StylusDescription& stylus, const TrialFigures& trial,
                                           const GainRequest& request = {}) noexcept;

/// The gains of one device, as its user keeps them.
struct KeptGains {
    GainLimits now, before; ///< in use, and those that they replaced
    GainRequest request;

    /// For a session: `now`, within the ceiling.
    GainLimits inForce() const noexcept;
    void use(const GainLimits& limits) noexcept; ///< The previous ones are kept in `before`
    void restore() noexcept;                     ///< Uses `before`; once more, the ones that were in use
};

} // namespace burin
