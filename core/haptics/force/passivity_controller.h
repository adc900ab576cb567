// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstddef>

namespace burin {

/// Monitors the energy that the sampled loop gives to the hand, and dissipates it by a damper when it gives more than
/// it received (Hannaford & Ryu 2002). For forces (N, mm) or torques (N·mm, rad): both give mJ. Device frame.
/// Called in the haptic tick.
class PassivityController {
public:
    /// ticks; the energy of devices with a longer delay is computed as if they had none
    static constexpr long longestDelay = 7;

    struct Settings {
        double damping = 0.0;        ///< N·s/mm or N·mm·s/rad, maximum
        double restingDamping = 0.0; ///< the same for a hand at rest, whose velocity consists mostly of encoder steps
        double slowest = 0.0;        ///< mm/s or rad/s; at lower speeds a damper only causes noise
        long delay = 0;              ///< ticks until a force acts, in addition to the tick in which it is sent
    };
    /// Motion of the hand since the last tick.
    struct Motion {
        glm::dvec3 moved{0.0};    ///< mm or rad
        glm::dvec3 velocity{0.0}; ///< mm/s or rad/s
        bool rests = false;       ///< the motion consists mostly of encoder steps
    };
    explicit PassivityController(const Settings& settings) noexcept;

    /// @param force N or N·mm, requested. @param period s @return the damped force, to be limited and then passed to
    /// `sent`
    glm::dvec3 dampen(const glm::dvec3& force, const Motion& hand, double period) noexcept;
    /// The force that was really sent to the device until the next tick.
    void sent(const glm::dvec3& force) noexcept;
    /// Returns to the state before the first tick: the energy counts from 0, and nothing was sent.
    void reset() noexcept;
    /// Energy in mJ that the hand put in so far; negative: the hand received energy.
    double energy() const noexcept { return energy_; }

private:
    static constexpr double allowedDeficit = 0.015; ///< mJ
    static constexpr double largestCredit = 5.0;    ///< mJ; old losses do not compensate for new activity
    Settings settings_;
    double energy_ = 0.0;
    std::array<glm::dvec3, std::size_t{longestDelay} + 1> sent_{};
    std::size_t newest_ = 0; ///< index into `sent_`
};

} // namespace burin
