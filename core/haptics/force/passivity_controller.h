// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstddef>

namespace burin {

/// Watches the energy that the sampled loop gives to the hand and takes it back through a damper when it gives more
/// than it got (Hannaford & Ryu 2002). Of forces (N, mm) or of torques (N·mm, rad): both make mJ. Device frame.
/// Tick code.
class PassivityController {
public:
    static constexpr long longestDelay = 7; ///< ticks; a device that is later is watched as if it were not

    struct Settings {
        double damping = 0.0;        ///< N·s/mm or N·mm·s/rad, at most
        double restingDamping = 0.0; ///< the same, of a hand whose velocity is mostly its encoders' steps
        double slowest = 0.0;        ///< mm/s or rad/s; below it a damper does nothing but noise
        long delay = 0;              ///< ticks, beyond the one that it is sent in, until a force acts
    };
    /// The hand since the last tick.
    struct Motion {
        glm::dvec3 moved{0.0};    ///< mm or rad
        glm::dvec3 velocity{0.0}; ///< mm/s or rad/s
        bool rests = false;       ///< what moves is mostly the encoders
    };
    explicit PassivityController(const Settings& settings) noexcept;

    /// @param force N or N·mm, wanted. @param period s
    /// @return to be limited and then told to `sent`
    glm::dvec3 dampen(const glm::dvec3& force, const Motion& hand, double period) noexcept;
    /// What really went to the device until the next tick.
    void sent(const glm::dvec3& force) noexcept;
    /// As before the first tick: the hand's energy counts from 0, and nothing was sent.
    void reset() noexcept;
    /// mJ that the hand put in so far; negative: it was given some.
    double energy() const noexcept { return energy_; }

private:
    static constexpr double allowedDeficit = 0.015; ///< mJ
    static constexpr double largestCredit = 5.0;    ///< mJ; old losses do not pay for new activity
    Settings settings_;
    double energy_ = 0.0;
    std::array<glm::dvec3, std::size_t{longestDelay} + 1> sent_{};
    std::size_t newest_ = 0; ///< place in `sent_`
};

} // namespace burin
