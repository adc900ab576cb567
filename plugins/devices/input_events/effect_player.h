// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "plugins/devices/input_events/effect_port.h"
#include "plugins/devices/input_events/force_encoding.h"
#include "plugins/devices/input_events/input_devices.h"

#include <cstddef>
#include <vector>

namespace burin::input_events {

/// Plays the effects of one device. Each lasts `replayMilliseconds` and is started again before it ends, so that the
/// device falls silent by itself if Burin does. A device that centres its stick does not while this plays: a spring and
/// a damper within the ceiling take its place, so that the stick still returns. Without room for the spring the device
/// goes on centring. One thread; time is passed in.
class EffectPlayer {
public:
    static constexpr int replayMilliseconds = 100;
    static constexpr double renewAfter = 0.04;  ///< s after its start an effect is started again
    static constexpr double changeAfter = 0.02; ///< s between two changes of an effect: a slow bus has to follow
    static constexpr double settleAfter = 0.1;  ///< s after which changes of less than 1/128 are sent, too
    static constexpr double springShare = 0.5;  ///< of the strongest spring
    static constexpr double damperShare = 0.25; ///< of the strongest damper
    static constexpr int full = 0xffff;         ///< of gain and centring

    /// @param port outlives the player
    EffectPlayer(EffectPort& port, const ForceAbilities& abilities) : port_(port), abilities_(abilities) {}

    /// Sets the gain, makes the effects, switches the centring off. Returns the error number of a call that failed, 0:
    /// none. After an error nothing else but `end` may be called.
    int begin();
    /// Shows these levels from now on, until the effects end. To be called at least every 20 ms. Returns as `begin`.
    /// @param now s, never less than in the call before
    int show(const EffectLevels& levels, double now) noexcept;
    /// Stops everything; the device centres its stick again.
    void end() noexcept;

private:
    struct Effect {
        ff_effect uploaded{}; ///< as the device has it
        bool playing = false;
        double startedAt = 0.0, changedAt = 0.0; ///< s
    };
    int add(const ff_effect& effect);
    int show(Effect& effect, const ff_effect& wanted, double now) noexcept;

    EffectPort& port_;
    const ForceAbilities abilities_;
    std::vector<Effect> effects_;
    bool centringOff_ = false;
};

} // namespace burin::input_events
