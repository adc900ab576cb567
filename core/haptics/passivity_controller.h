// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/hand_input.h"

#include <array>
#include <cstddef>

namespace burin {

/// Watches the energy that the sampled loop gives to the hand and takes it back through a damper when it gives more
/// than it got (Hannaford & Ryu 2002). Device frame. Tick code.
class PassivityController {
public:
    static constexpr long longestDelay = 7; ///< ticks; a device that is later is watched as if it were not

    struct Settings {
        double damping = 0.0;        ///< N·s/m, at most
        double restingDamping = 0.0; ///< N·s/m, on a hand whose velocity is mostly its encoders' steps
        long delay = 0;              ///< ticks, beyond the one that it is sent in, until a force acts
    };
    explicit PassivityController(const Settings& settings) noexcept;

    /// @param force N, wanted. @param period s
    /// @return N, to be limited and then told to `sent`
    glm::dvec3 operator()(const glm::dvec3& force, const Hand& hand, double period) noexcept;
    /// What really went to the device until the next tick.
    void sent(const glm::dvec3& force) noexcept;
    void reset() noexcept;
    /// J that the hand put in so far; negative: it was given some.
    double energy() const noexcept { return energy_; }

private:
    static constexpr double allowedDeficit = 0.015e-3; ///< J
    static constexpr double largestCredit = 5e-3;      ///< J; old losses do not pay for new activity
    static constexpr double slowest = 0.1;             ///< mm/s; below it a damper does nothing but noise
    Settings settings_;
    double energy_ = 0.0;
    std::array<glm::dvec3, std::size_t{longestDelay} + 1> sent_{};
    std::size_t newest_ = 0; ///< place in `sent_`
    glm::dvec3 position_{0.0};
    bool known_ = false;
};

} // namespace burin
