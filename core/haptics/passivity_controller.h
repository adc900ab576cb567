// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

namespace burin {

/// Watches the energy that the sampled loop gives to the hand and takes it back through a damper when it gives more
/// than it got (Hannaford & Ryu 2002). Device frame.
class PassivityController {
public:
    /// @param maximumDamping N·s/m that the device bears
    explicit PassivityController(double maximumDamping) noexcept : maximumDamping_(maximumDamping) {}

    /// @param force    N, wanted. @param position mm, of the hand. @param velocity mm/s, of the hand
    /// @param period   s
    /// @return N, to be limited and then told to `sent`
    glm::dvec3 operator()(const glm::dvec3& force, const glm::dvec3& position, const glm::dvec3& velocity,
                          double period) noexcept;
    /// What really went to the device until the next tick.
    void sent(const glm::dvec3& force) noexcept { sent_ = force; }
    void reset() noexcept;
    /// J that the hand put in so far; negative: it was given some.
    double energy() const noexcept { return energy_; }

private:
    static constexpr double allowedDeficit = 0.05e-3; ///< J
    static constexpr double largestCredit = 5e-3;     ///< J; old losses do not pay for new activity
    static constexpr double slowest = 0.1;            ///< mm/s; below it a damper does nothing but noise
    double maximumDamping_;
    double energy_ = 0.0;
    glm::dvec3 sent_{0.0}, position_{0.0};
    bool known_ = false;
};

} // namespace burin
